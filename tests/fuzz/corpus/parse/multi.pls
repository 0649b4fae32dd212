plsc 1
alphabet plasticoding 1
sense w: bool
environment e { w = True }
genotype a
rule C -> { C B }
test t in e -> body C
genotype b
iterations 1
rule C -> if w = True then { C add_front A1(0.5, 1, 2, 3) }
test u in e after 1 -> { C add_front A1 }
test v in e -> body C { front A1 }
