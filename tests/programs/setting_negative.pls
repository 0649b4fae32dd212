plsc 1
alphabet plasticoding 1
iterations -1  # expect error[P2014]
max_modules 1001  # expect error[P2014]
