plsc 1
alphabet plasticoding 1
sense inclined: bool
rule C -> if inclined = True, inclined = False then { C }  # expect error[P1106]
