# A robot for flat and tilted ground.

plsc 1

genotype gecko
alphabet plasticoding 1          # Table 1 of the paper, built in
sense inclined: bool             # IMU: centre of mass inclined
sense hot: bool
let w0 = 0.41
axiom C
iterations 3
max_modules 15

# flat and cool: two joints
rule C -> if inclined = False then {
  C
  move_ref_N(1, 1)
  add_edge(0.20784007719238895)
  add_left
  A1(-0.7319955605784404, 1.5902466023171207, 6.432601947036574, 2.276114)
  move_left
}
rule A1 -> if hot = True or inclined = True then { move_ref_N(1, 1) mutate_amp(-0.25) add_front T(0.78) move_back }
rule C -> if inclined = True and hot = False then {
  C
  move_ref_I(1, 2)  # the second input
  loop(-0.991706)
  add_edge(w0)
  # and a brick
  add_front
  B
  move_front
  # nothing more
}
rule B -> { move_ref_I(1, 1) mutate_per(0.8) add_right T(0.5) move_back }   # no clause: always active
environment flat { inclined = False, hot = False }
environment tilted { inclined = True, hot = False }
# the end
