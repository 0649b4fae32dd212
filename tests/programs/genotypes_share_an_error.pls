plsc 1
alphabet plasticoding 1
sense inclined: bool
rule B -> if hot = True then { B }  # expect error[P2005]
iterations 2
genotype gecko
iterations 3  # expect error[P2013]
rule C -> { C add_left B }
genotype snake
environment e { inclined = 2 }  # expect error[P2006]
rule C -> { C add_front B }
