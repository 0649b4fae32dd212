# A snake with a travelling wave, out of two rules.
#
# C is rewritten in every iteration, and each rewriting puts the whole rule of C
# in front once more: six rewritings, six segments. Each segment ends with the
# turtle on its tip, so the next one continues there.
#
# The joint's own rule makes the wave. A segment that has been rewritten n times
# carries n mutate_off commands behind its joint, so each segment swings a tenth
# of a period before the one behind it, and the wave runs towards the tail. Try
# `plsc develop` with `iterations 2` and watch the string.

plsc 1

genotype snake
alphabet plasticoding 1
iterations 6
max_modules 15

rule C -> {
  C
  add_front
  A1(0.5, 1.5, 3.0, 2.0)
  move_front
  add_front
  B
  move_front
}

rule A1 -> {
  A1(0.5, 1.5, 3.0, 2.0)
  mutate_off(-0.1)
}
