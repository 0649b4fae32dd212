# Plastic in two states, so one genotype has four bodies. `hot` chooses how the
# robot moves, `inclined` whether its head carries a crossbar.
#
#               cool                       hot
#   flat        crawls on its belly        walks on four legs
#   inclined    crawls, with a crossbar    walks, with a crossbar
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

let swing = 1.5  # amplitude of the joints that crawl
let beat = 2.0  # period of all joints, s
iterations 2

rule C -> {
  C
  B
  T(0.1)
}

# cool: a chain of horizontal joints, a wave that runs through it
rule B -> if hot = False then {
  add_front
  A2(0.5, swing, beat, 1.0)
  move_front
  add_front
  B
  move_front

  add_front
  A2(0.5, swing, beat, 1.1)
  move_front
  add_front
  B
  move_front

  add_front
  A2(0.5, swing, beat, 1.2)
  move_front
  add_front
  B
  move_front

  add_front
  A2(0.5, swing, beat, 1.3)
  move_front
  add_front
  B
  move_front
}

# hot: legs that lift the body, a spine, a head
rule B -> if hot = True then {
  add_left
  A2(0.5, 1.0, beat, 1.0)
  move_left
  add_front
  B
  move_back

  add_right
  A2(0.5, 1.0, beat, 1.5)
  move_right
  add_front
  B
  move_back

  add_front
  A1(0.5, 2.0, beat, 1.75)
  move_front
  add_front
  B
  move_front

  add_left
  A2(0.5, 1.0, beat, 1.5)
  move_left
  add_front
  B
  move_back

  add_right
  A2(0.5, 1.0, beat, 1.0)
  move_right
  add_front
  B
  move_back

  add_front
  B
  move_front
}

# a slope: a crossbar at the head, wherever that is. On flat ground T is meant to
# stay as it is, which `plsc lint` would otherwise ask about.
# plsc: allow W3003
rule T -> if inclined = True then {
  add_left
  B

  add_right
  B
}

environment flat_cool { inclined = False, hot = False }
environment flat_hot { inclined = False, hot = True }
environment tilted_cool { inclined = True, hot = False }
environment tilted_hot { inclined = True, hot = True }
