plsc 1
alphabet plasticoding 1
rule C -> { C add_front A2(0.5, 5.0, 2.0, 1.0) }
rule A2 -> { A2(-0, 1, 10, 1e0) add_front T(1) }
