plsc 1
alphabet plasticoding 1
sense inclined: bool
sense temperature: real in -40..60
iterations 2
rule C -> { C B T(0.1) }
rule B -> if inclined = True then { add_front B }  # expect warning[W3003]
# plsc: allow W3003
rule T -> if temperature > 30.5 then { add_left T(0.5) }
