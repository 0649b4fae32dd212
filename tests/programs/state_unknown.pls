plsc 1
alphabet plasticoding 1
sense inclined: bool
rule C -> if inclind = True then { C }  # expect error[P2005]
rule B -> if wet = True then { B }  # expect error[P2005]
environment flat { inclined = False, hot = True }  # expect error[P2005]
