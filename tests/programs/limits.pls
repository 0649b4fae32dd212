plsc 1
alphabet plasticoding 1
sense inclined: bool
sense hot: bool
max_terms 2
max_rules 1
rule C -> if inclined = True and hot = True or hot = False then { C }  # expect error[P3001]
rule C -> { C }  # expect error[P3001]
