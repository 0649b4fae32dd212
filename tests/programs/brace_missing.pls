plsc 1
alphabet plasticoding 1
sense hot: bool
rule B -> T(0.1)  # expect error[P1115]
rule T -> if hot = True then B  # expect error[P1115]
