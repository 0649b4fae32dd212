plsc 1
alphabet mine { replaceable X; terminal t(a: real }  # expect error[P1109]
axiom X
