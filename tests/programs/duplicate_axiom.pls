plsc 1
alphabet plasticoding 1
axiom C
axiom C  # expect error[P2013]
max_terms 2
max_terms 3  # expect error[P2013]
