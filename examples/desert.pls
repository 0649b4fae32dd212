# Plastic in two states, so one genotype has four bodies. `inclined` chooses the
# legs; `hot` chooses how much of the body touches the ground.
#
#               cool                      hot
#   flat        crawls on its belly       walks on stilts
#   inclined    crawls, with outriggers   stilts, with outriggers
#
# Clauses are joined as they are read: `and` binds tighter than `or`. Where two
# rules of a symbol are active, both are used, in file order.

plsc 1

genotype desert
alphabet plasticoding 1
sense inclined: bool
sense hot: bool
iterations 2

# the trunk, everywhere; B is a placeholder that the rules of B refine
rule C -> {
  C
  add_left A1(0.5, 1.0, 4.0, 1.0) move_left add_front B move_back
  add_right A1(0.5, 1.0, 4.0, 1.0) move_right add_front B move_back
}
# outriggers only where one could slide
rule C -> if inclined = True then {
  C
  add_front B
}
# hot ground: the placeholder becomes a joint that lifts the body
rule B -> if hot = True then {
  A2(0.5, 1.5, 4.0, 1.25)
}
# cool and flat, or cool and inclined: a brick with a sensor
rule B -> if hot = False and inclined = False or hot = False and inclined = True then {
  B
  add_front
  T(0.3)
}

environment flat_cool { inclined = False hot = False }
environment flat_hot { inclined = False hot = True }
environment tilted_cool { inclined = True hot = False }
environment tilted_hot { inclined = True hot = True }
