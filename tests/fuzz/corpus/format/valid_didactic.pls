plsc 1
alphabet didactic { replaceable X, Y, Z; terminal a }
axiom X
iterations 3
rule X -> { X Y }
rule Y -> { Z a }
rule Z -> { X Z }
