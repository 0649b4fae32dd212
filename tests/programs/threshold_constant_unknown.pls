plsc 1
alphabet plasticoding 1
sense warmth: real in 0..50
rule B -> if warmth > mild then { B }  # expect error[P2009]
