plsc 1
alphabet plasticoding  # expect error[P1118]
axiom C
