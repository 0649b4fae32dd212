plsc 1
alphabet plasticoding 1
sense inclined: bool
rule C -> if inclined = true then { C }  # expect error[P1104]
rule B -> { unknown_symbol }  # expect error[P2001]
