# A spider of four legs, one rule a leg. A symbol may have any number of rules;
# the productions of all active ones are joined in file order, and only the
# first brings the leading C. Read the four rules as one body plan.
#
# With move_to_new the turtle steps onto what it mounts, so a leg needs no
# moving commands outwards and three move_back to return. It is also the only
# way into the core's back: that side opens when the other three are taken.
#
# A leg is a joint that sweeps (A1), a joint that lifts (A2) and a foot. The
# left and the right legs row: each is down while it sweeps backwards.

plsc 1

genotype spider
alphabet plasticoding 1

let sweep = 2.0  # amplitude; beyond 1 the swing is wide and nearly square
let lift = 1.0
let beat = 3.0  # period, s
iterations 1
move_to_new True

# left
rule C -> {
  C

  add_left
  A1(0.5, sweep, beat, 1.0)

  add_front
  A2(0.5, lift, beat, 1.75)

  add_front
  B

  move_back
  move_back
  move_back
}

# right
rule C -> {
  C

  add_right
  A1(0.5, sweep, beat, 1.0)

  add_front
  A2(0.5, lift, beat, 1.25)

  add_front
  B

  move_back
  move_back
  move_back
}

# front: only lifts, to keep the front light
rule C -> {
  C

  add_front
  A2(0.5, lift, beat, 1.0)

  add_front
  B

  move_back
  move_back
}

# back: goes there whatever the command, because all other sides are taken
rule C -> {
  C

  add_front
  A2(0.5, lift, beat, 1.5)

  add_front
  B

  move_back
  move_back
}
