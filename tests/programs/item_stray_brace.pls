plsc 1
alphabet plasticoding 1
rule B -> { T(0.1) }
}  # expect error[P1101]
rule T -> { B }
