# One genotype, two bodies: plastic in `inclined`, which the robot's IMU senses.
#
# The first rule of C has no clause, so it is always active: a walker with four
# legs and a spine, as in gecko.pls. It leaves the turtle on the shoulder, where
# the other two rules go on. On flat ground one of them adds a touch sensor; on
# a slope the other adds a neck and a third pair of legs. Active rules are
# joined in file order, and only the first brings the leading C.

plsc 1

genotype climber
alphabet plasticoding 1
sense inclined: bool
iterations 1

# everywhere: hind legs, spine, shoulder, front legs
rule C -> {
  C

  add_left
  A2(0.4, 1.0, 2.0, 1.0)
  move_left
  add_front
  B
  move_back

  add_right
  A2(0.4, 1.0, 2.0, 1.5)
  move_right
  add_front
  B
  move_back

  add_front
  A1(0.7, 2.0, 2.0, 1.75)
  move_front
  add_front
  B
  move_front

  add_left
  A2(0.4, 1.0, 2.0, 1.5)
  move_left
  add_front
  B
  move_back

  add_right
  A2(0.4, 1.0, 2.0, 1.0)
  move_right
  add_front
  B
  move_back
}

# flat: feel what is ahead
rule C -> if inclined = False then {
  C

  add_front
  T(0.5)
}

# tilted: six legs hold better than four
rule C -> if inclined = True then {
  C

  add_front
  A1(0.7, 2.0, 2.0, 1.25)
  move_front
  add_front
  B
  move_front

  add_left
  A2(0.4, 1.0, 2.0, 1.0)

  add_right
  A2(0.4, 1.0, 2.0, 1.5)
}

environment flat { inclined = False }
environment tilted { inclined = True }
