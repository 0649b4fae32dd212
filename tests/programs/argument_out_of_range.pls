plsc 1
alphabet plasticoding 1
rule B -> {
  A1(0.1, 12.0, 3.0, 1.0)  # expect error[P2004]
  T(-1.0000000000000002)  # expect error[P2004]
  move_ref_I(0, 1)  # expect error[P2004]
  T(-1)
}
