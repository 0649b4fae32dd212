plsc 1
alphabet plasticoding 1
iterations  # expect error[P1108]
max_modules = 15  # expect error[P1108]
