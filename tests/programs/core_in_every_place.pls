plsc 1
alphabet plasticoding 1
rule B -> { C }  # expect error[P2008]
rule T -> { T(0.5) C add_left }  # expect error[P2008]
