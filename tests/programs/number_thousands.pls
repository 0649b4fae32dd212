plsc 1
alphabet plasticoding 1
rule B -> { move_ref_I(1_000, 2) }  # expect error[P1111]
