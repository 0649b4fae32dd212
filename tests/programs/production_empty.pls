plsc 1
alphabet plasticoding 1
rule B -> { }  # expect error[P1113]
