plsc 1
alphabet mine { replaceable Leaf; terminal turn(a: real in 0..9) }
axiom Leaf
rule Leaf -> { Lead turn(5) }  # expect error[P2001]
rule Leaf -> { turn(10) }  # expect error[P2004]
rule Leaf -> { turn }  # expect error[P2002]
