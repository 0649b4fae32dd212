plsc 1
alphabet plasticoding 1
sense a: real in 5..0  # expect error[P2016]
