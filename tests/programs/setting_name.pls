plsc 1
alphabet plasticoding 1
let three = 3
iterations three  # expect error[P2014]
