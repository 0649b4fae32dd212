plsc 1
alphabet plasticoding 1
iterations 4
max_modules 3

rule C -> {
  C
  add_front
  A1(0.5, 2, 3, 1)
  move_front
}
rule A1 -> {
  A1(0.5, 2, 3, 1)
  mutate_per(1)  # expect warning[W4003]
}
