plsc 1
alphabet plasticoding 1
<<<<<<< HEAD  # expect error[P5010]
iterations 3
=======
iterations 4
>>>>>>> other
