plsc 1
alphabet plasticoding 1
axiom  # expect error[P1102]
rule B -> { B }
