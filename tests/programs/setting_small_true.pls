plsc 1
alphabet plasticoding 1
move_to_new true  # expect error[P2014]
