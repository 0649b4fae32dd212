plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot = then { B }  # expect error[P1108]
