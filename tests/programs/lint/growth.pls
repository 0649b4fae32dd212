plsc 1
alphabet plasticoding 1
sense hot: bool
iterations 30  # expect warning[W4001]
rule C -> { C B }
rule B -> if hot = True then { add_left B B B }
rule B -> if hot = False then { add_left B }
