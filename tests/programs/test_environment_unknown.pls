plsc 1
alphabet plasticoding 1
sense inclined: bool
environment tilted { inclined = True }
rule C -> { C add_left B }
test a in tiltd -> body C { left B }  # expect error[P2020]
test b -> body C { left B }  # expect error[P2020]
test c in tilted -> body C { left B }
