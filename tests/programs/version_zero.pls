plsc 0  # expect error[P5002]
