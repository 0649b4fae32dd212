plsc 1
alphabet plasticoding 1
rule T -> { T(0.5f) }  # expect error[P1110]
