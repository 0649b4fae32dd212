plsc 1
alphabet plasticoding 1
sense a: real in 0-5  # expect error[P1115]
