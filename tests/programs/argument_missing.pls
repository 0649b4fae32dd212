plsc 1
alphabet plasticoding 1
rule T -> { T() }  # expect error[P1108]
rule B -> { A1(0.1, , 2, 3) }  # expect error[P1108]
