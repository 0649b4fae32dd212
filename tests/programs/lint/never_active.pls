plsc 1
alphabet plasticoding 1
sense hot: bool
iterations 1
rule C -> { C add_left B }
rule C -> if hot = True and hot = False then { C add_right B }  # expect warning[W3002]
