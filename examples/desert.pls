# Plastic in two states, so one genotype has four bodies. `hot` chooses how the
# robot stands, `inclined` whether it grows outriggers.
#
#               cool                       hot
#   flat        paddles on its belly       walks on stilts
#   inclined    paddles, with outriggers   stilts, with outriggers
#
# An idiom worth knowing: B and T in the rule of C come without a mounting
# command, so the modules themselves are never mounted. They are calls: the
# second rewriting replaces them by their own rules. In an environment where T
# has no active rule, it stays a T and is not expressed.

plsc 1

genotype desert
alphabet plasticoding 1
sense inclined: bool
sense hot: bool
iterations 2

let beat = 4.0 # period of all joints, s

rule C -> {
  C
  B
  T(0.1)
}

# cool: two paddles that sweep, and a sensor between them
rule B -> if hot = False then {
  add_left A1(0.5, 1.0, beat, 1.0) move_left add_front B move_back
  add_right A1(0.5, 1.0, beat, 1.5) move_right add_front B move_back
  add_front T(0.3)
}
# hot: four legs that lift the body off the ground
rule B -> if hot = True then {
  add_left A2(0.5, 2.0, beat, 1.0) move_left add_front B move_back
  add_right A2(0.5, 2.0, beat, 1.5) move_right add_front B move_back
  add_front A1(0.5, 1.0, beat, 1.25) move_front add_front B move_front
  add_left A2(0.5, 2.0, beat, 1.5) move_left add_front B move_back
  add_right A2(0.5, 2.0, beat, 1.0) move_right add_front B move_back
  move_back move_back
}
# a slope: a foot on each side that does not lift, wherever there is room
rule T -> if inclined = True then {
  move_left move_front add_left B move_back move_back
  move_right move_front add_right B move_back move_back
}

environment flat_cool { inclined = False hot = False }
environment flat_hot { inclined = False hot = True }
environment tilted_cool { inclined = True hot = False }
environment tilted_hot { inclined = True hot = True }
