plsc 1
alphabet plasticoding 1
rule T -> { T(1e400) }  # expect error[P1112]
rule T -> { T(1e-400) }  # expect error[P1112]
