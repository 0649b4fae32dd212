plsc 1
alphabet plasticoding 1
rule C -> if then { C }  # expect error[P1105]
