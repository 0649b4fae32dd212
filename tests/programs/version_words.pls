plsc one  # expect error[P5001]
alphabet plasticoding 1
