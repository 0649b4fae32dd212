plsc 1
genotype shy
alphabet plasticoding 1     # Table 1 of the paper: modules, commands
sense inclined: bool        # the IMU: does the robot stand on a slope?
iterations 1

rule C -> { C add_left A2(0.5, 2.0, 3.0, 1.0) move_left add_front B }
rule C -> if inclined = True then { C move_back add_right T(0.25) }

environment flat { inclined = False }
environment tilted { inclined = True }
