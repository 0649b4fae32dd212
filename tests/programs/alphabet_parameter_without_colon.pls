plsc 1
alphabet mine { replaceable X; terminal t(a real) }  # expect error[P1115]
axiom X
