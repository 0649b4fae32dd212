plsc 1
alphabet plasticoding 1
rule C -> { C add_left B }
test a -> body C
test a -> { C }  # expect error[P2017]
