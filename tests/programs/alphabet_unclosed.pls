plsc 1
alphabet mine { replaceable X  # expect error[P1107]
axiom X
