plsc 1
alphabet plasticoding 1
rule add_left -> { B }  # expect error[P2007]
