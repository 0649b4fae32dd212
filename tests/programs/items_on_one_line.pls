plsc 1
alphabet plasticoding 1
rule C -> { C } rule B -> { } rule T -> { T(0.5) } rule A1 -> { wheel }  # expect error[P1113] # expect error[P2001]
sense rule: bool  # expect error[P1102]
let axiom = 3  # expect error[P1102]
rule B -> { add_left rule T -> { T(1.) }  # expect error[P1107] # expect error[P1110]
iterations 3
my_rule B -> { wheel }  # expect error[P1101]
wheel rule B -> { wheel }  # expect error[P2001]
