# One genotype, two bodies: plastic in `inclined`.
#
# The rules of C without a clause build what every body has. The others are
# switched by what the robot's IMU senses: on flat ground it grows four legs and
# a spine that walk; on a slope it grows a low chain of joints that crawls, and
# a wide tail that keeps it from rolling down.

plsc 1

genotype climber
alphabet plasticoding 1
sense inclined: bool
iterations 1

# always: the core and a touch sensor that faces uphill
rule C -> {
  C
}
# flat: hind legs, spine, shoulder, front legs
rule C -> if inclined = False then {
  C
  add_left A2(0.4, 1.2, 3.0, 1.0) move_left add_front B move_back
  add_right A2(0.4, 1.2, 3.0, 1.5) move_right add_front B move_back
  add_front A1(0.7, 2.0, 3.0, 1.25) move_front add_front B move_front
  add_left A2(0.4, 1.2, 3.0, 1.5) move_left add_front B move_back
  add_right A2(0.4, 1.2, 3.0, 1.0) move_right add_front B move_back
}
# tilted: a chain to the front that crawls, outriggers at the sides
rule C -> if inclined = True then {
  C
  add_left B
  add_right B
  add_front A2(0.4, 1.5, 4.0, 1.0) move_front
  add_front B move_front
  add_front A2(0.4, 1.5, 4.0, 1.3) move_front
  add_front B move_front
  add_left T(0.5)
}

environment flat { inclined = False }
environment tilted { inclined = True }
