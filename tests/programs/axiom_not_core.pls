plsc 1
alphabet plasticoding 1
axiom B  # expect error[P2011]
