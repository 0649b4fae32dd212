plsc 1
alphabet plasticoding 1
iterations 1
rule C -> {
  C
  B  # expect warning[W4002]
  add_left  # expect warning[W4002]
  add_right
  B
  add_right  # expect warning[W4002]
  A1(0.5, 1, 2, 1)  # expect warning[W4002]
  loop(0.5)  # expect warning[W4002]
  move_back  # expect warning[W4002]
}
