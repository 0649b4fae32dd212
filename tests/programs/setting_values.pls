plsc 1
alphabet plasticoding 1
iterations 1.5  # expect error[P2014]
max_modules 0  # expect error[P2014]
move_to_new 1  # expect error[P2014]
max_terms 1e3  # expect error[P2014]
max_rules 99999999999999999999  # expect error[P2014]
