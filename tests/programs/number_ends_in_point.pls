plsc 1
alphabet plasticoding 1
rule B -> { A1(0.1, 2., 3, 4) }  # expect error[P1110]
