plsc 1
alphabet plasticoding 1
B -> { T(0.1) }  # expect error[P1101]
