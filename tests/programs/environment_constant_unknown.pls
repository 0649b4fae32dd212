plsc 1
alphabet plasticoding 1
sense warmth: real in 0..50
let mild = 12
environment e { warmth = midl }  # expect error[P2009]
