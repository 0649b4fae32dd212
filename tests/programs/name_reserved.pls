plsc 1
alphabet plasticoding 1
sense rule: bool  # expect error[P1102]
