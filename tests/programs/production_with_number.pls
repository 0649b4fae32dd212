plsc 1
alphabet plasticoding 1
rule B -> { B 5 }  # expect error[P1116]
