Plsc 1  # expect error[P5001]
alphabet plasticoding 1
