plsc 1
alphabet plasticoding 1
rule T -> { T(0.5,) }  # expect error[P1108]
