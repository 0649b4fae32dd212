plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot = True || hot = False then { B }  # expect error[P1104]
