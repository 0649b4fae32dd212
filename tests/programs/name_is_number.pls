plsc 1
alphabet plasticoding 1
sense 5: bool  # expect error[P1102]
