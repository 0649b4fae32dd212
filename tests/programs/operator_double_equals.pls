plsc 1
alphabet plasticoding 1
sense inclined: bool
sense hot: bool
rule C -> if inclined == true && hot = False then { C }  # expect error[P1104]
