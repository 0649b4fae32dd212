plsc 1
alphabet mine { X, Y }  # expect error[P1116]
alphabet yours { replaceable X(a: number) }  # expect error[P1117]
axiom X
