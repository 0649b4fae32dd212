plsc 1
alphabet plasticoding 1
let weight = 0.5
rule T -> { T(wieght) }  # expect error[P2009]
