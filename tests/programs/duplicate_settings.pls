plsc 1
alphabet plasticoding 1
iterations 3
iterations 4  # expect error[P2013]
alphabet plasticoding 1  # expect error[P2013]
