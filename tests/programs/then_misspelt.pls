plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if hot = True than { B }  # expect error[P1106]
