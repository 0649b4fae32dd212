plsc 1
alphabet plasticoding 1
€ 5  # expect error[P1101]
