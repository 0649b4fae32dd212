plsc 1
alphabet plasticoding 1
sense inclined: bool
sense hot: bool
iterations 1
rule C -> { C add_left B }
rule C -> if inclined = True then { C add_right B }
rule C -> if hot = True then { C add_front B }
