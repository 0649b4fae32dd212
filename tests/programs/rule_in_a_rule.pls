plsc 1
alphabet plasticoding 1
rule B -> {  # expect error[P1107]
  B
  rule T -> { T(0.5) }
