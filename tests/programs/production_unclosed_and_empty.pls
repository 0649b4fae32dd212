plsc 1
alphabet plasticoding 1
rule B -> {  # expect error[P1107]
rule T -> { T(0.1) }
