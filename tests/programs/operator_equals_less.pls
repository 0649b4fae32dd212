plsc 1
alphabet plasticoding 1
sense w: real in 0..9
rule B -> if w =< 5 then { B }  # expect error[P1104]
