plsc 1
alphabet plasticoding 1
rule T -> { T(0.5 add_left }  # expect error[P1109]
rule B -> {
  A1(0.1, 2.0, 3.0, 4.0  # expect error[P1109]
  add_left
}
