# The didactic grammar of the paper ("Mapping stage 1: early-development"): a
# file may bring an alphabet of its own. `plsc develop` prints the string after
# each rewriting:
#
#   Iteration 0: X
#   Iteration 1: X Y
#   Iteration 2: X Y Z a
#   Iteration 3: X Y Z a X Z a

plsc 1

genotype didactic
alphabet didactic {
  replaceable X, Y, Z;
  terminal a
}
axiom X
iterations 3

rule X -> {
  X
  Y
}

rule Y -> {
  Z
  a
}

rule Z -> {
  X
  Z
}

test iteration_0 after 0 -> { X }

test iteration_1 after 1 -> { X Y }

test iteration_2 after 2 -> { X Y Z a }

test iteration_3 after 3 -> { X Y Z a X Z a }
