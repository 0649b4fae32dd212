genotype gecko  # expect error[P5001]
alphabet plasticoding 1
rule B -> { T(0.1) }
