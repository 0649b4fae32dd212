plsc 1
alphabet plasticoding 1
genotype gecko
rule C -> { C add_left B }
genotype snake
rule C -> { C add_lef B }  # expect error[P2001]
genotype gecko  # expect error[P2017]
rule C -> { C add_front B }
