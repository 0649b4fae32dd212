plsc 1
alphabet plasticoding 1
sense inclined: bool
genotype gecko
rule C -> { C add_left B }
genotype snake  # expect error[P2019]
rule C -> { C add_front B }
