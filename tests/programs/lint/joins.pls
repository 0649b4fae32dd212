plsc 1
alphabet plasticoding 1
sense inclined: bool
sense ground: { dry, wet, icy }
iterations 1
rule C -> if inclined = True then { C add_left B }
rule C -> if inclined = False then { C add_right B }
rule C -> if ground = icy then { C add_front T(1) }  # expect warning[W3004]
