plsc 1
alphabet plasticoding 1
sense hot: bool
environment e { hot True }  # expect error[P1115]
