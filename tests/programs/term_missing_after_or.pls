plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot = True or then { B }  # expect error[P1105]
