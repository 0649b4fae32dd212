plsc 1
alphabet mine { replaceable X; terminal a(n: int) }
axiom X
rule X -> { X a(1) }
test a -> body X  # expect error[P2021]
test b after 1 -> { X a }
test c after 1 -> { X a(1.5) }  # expect error[P2003]
test d after 1 -> { X a() }  # expect error[P1108]
test e after 1 -> { X b }  # expect error[P2001]
