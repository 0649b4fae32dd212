plsc 1
alphabet plasticoding 1
let far = 1.5
rule B -> { move_ref_I(far, 1) }  # expect error[P2003]
