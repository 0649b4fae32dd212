plsc 1
alphabet o {
  replaceable X, Y(n: int in 1..5)
  terminal z(a: real, b: real in 0..1)
}
axiom X
iterations 4
rule X -> { X Y(2) z(-1.5e3, 0.5) }
rule Y -> { Y(1) Y(5) }
test q after 1 -> { X Y z(-1500, 0.5) }
