plsc 1
alphabet plasticoding 1
sense inclined: bool
environment flat { inclined = False }
test -> { C }  # expect error[P1102]
test a in -> { C }  # expect error[P1102]
test b flat -> { C }  # expect error[P1115]
test c in flat { C }  # expect error[P1115]
test d in flat -> C  # expect error[P1115]
test e in flat -> body  # expect error[P1116]
test f in flat -> body { C }  # expect error[P1116]
test g in flat -> body C { left }  # expect error[P1116]
test h in flat -> body C { left B  # expect error[P1107]
test i in flat -> body C { left B, right B }  # expect error[P1116]
test j in flat -> { }  # expect error[P1113]
test k in flat -> { C 3 }  # expect error[P1116]
test l in flat -> body C
