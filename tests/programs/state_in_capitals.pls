plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> if Hot = True then { B }  # expect error[P2005]
