plsc 3  # expect error[P5002]
alphabet plasticoding 1
gait trot
