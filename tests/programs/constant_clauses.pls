plsc 1
alphabet plasticoding 1
sense inclined: bool
sense t: real in 0..10
rule C -> if inclined = True or inclined = False then { C }  # expect warning[W3002]
rule B -> if inclined = True and inclined != True then { B }  # expect warning[W3002]
rule B -> if t > 10 then { B }  # expect warning[W3002]
rule B -> if t < 5 or t >= 5 then { B }  # expect warning[W3002]
rule T -> if inclined = True and t > 5 then { B }
