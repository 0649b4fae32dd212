plsc 1
alphabet plasticoding 1
iterations 1
rule C -> { C add_front B }
rule B -> { add_left T(1) }  # expect warning[W4002]
rule T -> { add_left B }  # expect warning[W4002]
