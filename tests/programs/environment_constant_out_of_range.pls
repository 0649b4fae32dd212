plsc 1
alphabet plasticoding 1
sense warmth: real in 0..50
let boiling = 100
environment e { warmth = boiling }  # expect error[P2015]
