plsc 1
alphabet many { replaceable X; terminal a }
axiom X
let unused = 1
rule X -> {  # expect warning[W4001]
  X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X
  X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X
  X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X X
}
