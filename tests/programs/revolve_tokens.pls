C C brainmoveTTS_1|2 addf AJ1_0.5|2|3|4 movef  # expect error[P5012]
B B addl ST_0.5
