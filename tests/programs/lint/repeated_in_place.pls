plsc 1
alphabet plasticoding 1
iterations 3

rule C -> {  # expect warning[W4004]
  C
  add_left
  A1(0.5, 2, 3, 1)
  move_left
  add_front
  B
  move_back
}
