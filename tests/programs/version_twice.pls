plsc 1
alphabet plasticoding 1
plsc 1  # expect error[P1101]
