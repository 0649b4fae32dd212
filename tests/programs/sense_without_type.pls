plsc 1
alphabet plasticoding 1
sense hot:  # expect error[P1117]
rule B -> { B }
