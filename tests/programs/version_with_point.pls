plsc 1.5  # expect error[P5001]
alphabet plasticoding 1
rule B -> { wheel }  # expect error[P2001]
