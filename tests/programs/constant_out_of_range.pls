plsc 1
alphabet plasticoding 1
let strong = 1.5
rule B -> { T(strong) }  # expect error[P2004]
