plsc 1
alphabet plasticoding 1.0  # expect error[P5003]
