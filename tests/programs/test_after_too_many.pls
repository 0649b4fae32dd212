plsc 1
alphabet plasticoding 1
iterations 2
rule C -> { C add_left B }
test a after 3 -> { C }  # expect error[P2020]
test b after 1.5 -> { C }  # expect error[P2020]
test c after 2 -> { C }
test d after -> { C }  # expect error[P1108]
