plsc 1
alphabet plasticoding 1
rule B -> {
  move_ref_I(1.5, 2)  # expect error[P2003]
  move_ref_N(1, 2e0)  # expect error[P2003]
  move_ref_N(1, 2)
}
