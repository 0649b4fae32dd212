plsc 1
alphabet mine { replaceable X, Y }
axiom Z  # expect error[P2001]
