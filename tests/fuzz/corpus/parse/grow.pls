plsc 1
alphabet plasticoding 1
iterations 60
rule C -> { C B B }
rule B -> { B B add_front B }
