plsc 1
alphabet mine { replaceable X, Y }  # expect error[P2012]
rule X -> { Y }
