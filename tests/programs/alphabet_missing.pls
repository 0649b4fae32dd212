plsc 1  # expect error[P2012]
rule B -> { B }
