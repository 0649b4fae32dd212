plsc 1
alphabet plasticoding 1
sense ground: { dry wet }  # expect error[P1116]
