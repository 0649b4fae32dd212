plsc 1
alphabet plasticoding 1
let w 0.5  # expect error[P1115]
