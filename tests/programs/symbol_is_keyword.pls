plsc 1
alphabet plasticoding 1
rule B -> { add_left if T(0.1) }  # expect error[P1116]
