plsc 1
alphabet plasticoding { replaceable X }  # expect error[P2010]
