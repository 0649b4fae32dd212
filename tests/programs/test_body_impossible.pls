plsc 1
alphabet plasticoding 1
rule C -> { C add_left B }
test a -> body B  # expect error[P2021]
test b -> body C { left C }  # expect error[P2021]
test c -> body C { up B }  # expect error[P2021]
test d -> body C { left B left T }  # expect error[P2021]
test e -> body C { left A1 { left B } }  # expect error[P2021]
test f -> body C { left T { front B } }  # expect error[P2021]
test g -> body C { left add_left }  # expect error[P2021]
test h -> body C { left AJ1 }  # expect error[P2001]
test i -> body C { front T left B { right A2 { front T } } }
