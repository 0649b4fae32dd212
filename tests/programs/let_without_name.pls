plsc 1
alphabet plasticoding 1
let = 0.5  # expect error[P1102]
