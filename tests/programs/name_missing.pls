plsc 1
genotype  # expect error[P1102]
alphabet plasticoding 1
