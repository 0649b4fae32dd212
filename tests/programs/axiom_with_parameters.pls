plsc 1
alphabet mine { replaceable X(a: real), Y }
axiom X  # expect error[P2011]
rule Y -> { Y }
