plsc 1
alphabet mine { replacable X }  # expect error[P1116]
axiom X
