plsc 1
alphabet mine { replaceable X; terminal a }
axiom X
rule a -> { X }  # expect error[P2007]
