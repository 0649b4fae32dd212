plsc 1
alphabet plasticoding 1
sense ground: { dry, bool }  # expect error[P1102]
