plsc 1
alphabet plasticoding 1
sense a: real in 5..5  # expect error[P2016]
sense b: { one }  # expect error[P2016]
sense c: { one, two, one }  # expect error[P2016]
