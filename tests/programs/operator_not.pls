plsc 1
alphabet plasticoding 1
sense inclined: bool
rule C -> if not inclined = True then { C }  # expect error[P1104]
rule B -> if !inclined then { B }  # expect error[P1104]
