plsc 1
alphabet own { replaceable X, Y; terminal a }
axiom X
iterations 3
rule X -> { a X a }
rule Y -> { a }  # expect warning[W4002]
