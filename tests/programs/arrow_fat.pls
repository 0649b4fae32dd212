plsc 1
alphabet plasticoding 1
rule B => { B }  # expect error[P1115]
