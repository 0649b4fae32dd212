plsc 1
alphabet plasticoding 1
test flat  # expect error[P1101]
