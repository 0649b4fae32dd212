plsc 1
alphabet plasticoding 1
sense ground: { dry, wet }
environment e { ground = wett }  # expect error[P2006]
