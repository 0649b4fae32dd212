plsc 1
alphabet plasticoding 1
max_rules 1
rule B -> { B }
rule B -> { T(0.5) }  # expect error[P3001]
