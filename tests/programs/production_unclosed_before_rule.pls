plsc 1
alphabet plasticoding 1
sense inclined: bool
rule C -> if inclined = True then {  # expect error[P1107]
  C
  add_left

rule B -> { add_left T(0.1) }
