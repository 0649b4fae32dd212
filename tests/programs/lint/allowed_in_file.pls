plsc 1
# plsc: allow-file W3003 W3004
alphabet plasticoding 1
sense hot: bool
sense wet: bool
iterations 2
rule C -> { C B }
rule B -> if hot = True then { add_left B }
rule B -> if wet = True then { add_right B }
# plsc: allow W3999  # expect warning[W1001]
environment dry { hot = False, wet = False }
