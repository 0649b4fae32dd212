plsc 1
alphabet plasticoding 1
rule B -> { add_left C }  # expect error[P2008]
rule C -> { C add_left C }  # expect error[P2008]
rule C -> { add_left B }  # expect error[P2008]
