plsc 1
alphabet plasticoding 1
include other  # expect error[P1101]
