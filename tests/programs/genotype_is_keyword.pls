plsc 1
genotype rule  # expect error[P1102]
alphabet plasticoding 1
