plsc 1
alphabet mine { replaceable rule }  # expect error[P1102]
axiom X
