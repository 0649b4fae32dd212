plsc 1
alphabet plasticoding 1
rule T -> { T(1e) }  # expect error[P1110]
rule B -> { T(1e-) }  # expect error[P1110]
