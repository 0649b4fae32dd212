plsc 1
alphabet plasticoding 1
sense hot: bool
environment { hot = True }  # expect error[P1102]
