plsc 1
alphabet plasticoding 1
sense hot: bool
iterations 2
rule C -> { C B }
rule B -> if hot = True then { add_left B }
rule B -> if hot = False then { add_right A1(1, 2, 3, 4) }
