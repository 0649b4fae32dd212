plsc 1
alphabet plasticoding 1
rule T -> { T(-1.) }  # expect error[P1110]
