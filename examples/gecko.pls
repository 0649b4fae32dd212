# A baseline walker: no states, no clauses, so every rule is always active and
# the robot is the same everywhere.
#
# The core carries the hind legs, a joint with a vertical axis (A1) is the
# spine, and a brick in front of it carries the front legs. Each leg is a joint
# with a horizontal axis (A2), which lifts, and a foot. The spine bends from side
# to side and carries the lifted legs forward; legs on a diagonal lift together
# (phase offsets are in periods: 1.0 and 1.5 are opposite).

plsc 1

genotype gecko
alphabet plasticoding 1

let beat = 2.0  # period of the gait, s
let lift = 1.0  # amplitude of the legs
let bend = 2.0  # amplitude of the spine
iterations 1

rule C -> {
  C

  # hind legs
  add_left
  A2(0.4, lift, beat, 1.0)
  move_left
  add_front
  B
  move_back
  add_right
  A2(0.4, lift, beat, 1.5)
  move_right
  add_front
  B
  move_back

  # spine and shoulder
  add_front
  A1(0.7, bend, beat, 1.75)
  move_front
  add_front
  B
  move_front

  # front legs, opposite to the hind leg of their side
  add_left
  A2(0.4, lift, beat, 1.5)
  move_left
  add_front
  B
  move_back
  add_right
  A2(0.4, lift, beat, 1.0)
  move_right
  add_front
  B
  move_back
}
