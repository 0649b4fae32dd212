plsc 1
alphabet plasticoding 1
rule T -> { T(0x10) }  # expect error[P1111]
