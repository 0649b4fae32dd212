plsc 1
alphabet plasticoding 1
rule B -> { T(0.5) }  # café  # expect error[P5011]
