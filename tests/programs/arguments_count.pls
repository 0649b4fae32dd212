plsc 1
alphabet plasticoding 1
rule B -> { A1(0.1, 2.0, 3.0) }  # expect error[P2002]
rule B -> { B(1) }  # expect error[P2002]
rule B -> { T }  # expect error[P2002]
rule B -> { T(0.1, 0.2) }  # expect error[P2002]
