plsc 1
alphabet plasticoding 1
sense hot: bool
environment e { hot = }  # expect error[P1108]
