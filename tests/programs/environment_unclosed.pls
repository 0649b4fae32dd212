plsc 1
alphabet plasticoding 1
sense hot: bool
environment warm {  # expect error[P1107]
  hot = True
rule B -> { B }
