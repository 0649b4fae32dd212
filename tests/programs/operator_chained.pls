plsc 1
alphabet plasticoding 1
sense t: real in -40..60
rule C -> if 10 < t < 20 then { C }  # expect error[P1105]
rule B -> if t > 10 < 20 then { B }  # expect error[P1106]
