plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> hot = True then { B }  # expect error[P1115]
