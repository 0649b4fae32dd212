# Each reading goes on where the one before ended; and calls are expressed by no
# reading of C.
plsc 1
alphabet plasticoding 1
iterations 3

rule C -> {
  C
  B
  add_front
  A1(0.5, 2, 3, 1)
  move_front
}
rule B -> {
  loop(0.5)  # expect warning[W4002]
}
