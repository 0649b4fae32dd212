plsc 1
alphabet plasticoding 1
sense a: real  # expect error[P1115]
sense b: real in 0  # expect error[P1115]
sense c: real in 0 to 5  # expect error[P1115]
sense d: real in 0..  # expect error[P1108]
