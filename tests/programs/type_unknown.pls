plsc 1
alphabet plasticoding 1
sense hot: boolean  # expect error[P1117]
sense t: 5  # expect error[P1117]
