plsc 1
genotype first
alphabet plasticoding 1
genotype second  # expect error[P2013]
