plsc 1
alphabet 1  # expect error[P1102]
