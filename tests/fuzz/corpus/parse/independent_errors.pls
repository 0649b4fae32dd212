plsc 1
alphabet plasticoding 1
sense inclined: boolean  # expect error[P1117]
iterations 3.5  # expect error[P2014]
rule C -> if inclined = True then { C }
rule C -> {  # expect error[P1107]
  C
rule B -> { A1(0.1, 2.0, 3.0) }  # expect error[P2002]
rule T -> { T(1.) }  # expect error[P1110]
rule A1 -> { wheel }  # expect error[P2001]
