plsc 1
alphabet plasticoding 1
sense a: real in 0..1e999  # expect error[P1112]
