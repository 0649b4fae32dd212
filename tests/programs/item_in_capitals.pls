plsc 1
alphabet plasticoding 1
Rule B -> { B }  # expect error[P1101]
