plsc 1
alphabet plasticoding 1
rule T -> { T(1e+) }  # expect error[P1110]
rule T -> { T(1e0.5) }  # expect error[P1110]
