plsc 1
alphabet mine { replaceable X; terminal t(a: real in low..high) }  # expect error[P1108]
axiom X
