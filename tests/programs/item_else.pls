plsc 1
alphabet plasticoding 1
sense hot: bool
rule C -> if hot = True then { C add_left B } else { C }  # expect error[P1101]
