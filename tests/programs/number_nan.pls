plsc 1
alphabet plasticoding 1
rule T -> { T(nan) }  # expect error[P1111]
rule T -> { T(-inf) }  # expect error[P1111]
rule T -> { T(Infinity) }  # expect error[P1111]
