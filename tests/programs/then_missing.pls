plsc 1
alphabet plasticoding 1
sense inclined: bool
rule C -> if inclined = True {  # expect error[P1106]
  C
}
rule B -> { wheel }  # expect error[P2001]
