plsc 1
alphabet plasticoding 1
rule C -> {  # expect error[P1107]
  C
