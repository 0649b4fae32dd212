plsc 1
alphabet plasticoding 1
>>>>>>> theirs  # expect error[P5010]
