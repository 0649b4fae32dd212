plsc 1
alphabet plasticoding 1
sense hot: bool
rule C -> if (hot = True) then { C }  # expect error[P1114]
rule B -> if hot = True and (hot = True or hot = False) then { B }  # expect error[P1114]
rule T -> if hot = True) then { T(0.1) }  # expect error[P1114]
