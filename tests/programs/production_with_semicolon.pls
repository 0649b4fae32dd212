plsc 1
alphabet plasticoding 1
rule B -> { add_left; T(0.5) }  # expect error[P1116]
