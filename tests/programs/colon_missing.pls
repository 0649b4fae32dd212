plsc 1
alphabet plasticoding 1
sense hot bool  # expect error[P1115]
sense cold = bool  # expect error[P1115]
