plsc 1
alphabet plasticoding 1
sense g: { dry, wet, ice }
sense t: real in -4..6
let k = 2.5
max_modules 3
move_to_new True
rule C -> if g = wet and t > k or t <= -1 then { C add_left T(1) add_front B }
rule B -> if g != dry then { B add_right A2(0.5, k, 1, 1) }
environment n { g = ice, t = 6 }
