plsc 1
alphabet plasticoding 2  # expect error[P5003]
