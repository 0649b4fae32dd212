plsc 1
genotype plant
alphabet turtle {
  replaceable F(length: real in 0..10), Start
  terminal turn(angle: real in -180..180), push, pop, repeat(n: int in 1..9, m: int)
  replaceable Leaf
}
axiom Start
iterations 5
move_to_new True
max_terms 4
max_rules 7
sense light: real in -1e3..1.5e3
sense season: { spring, summer, autumn, winter }
let half = 0.5
let dim = -20
rule Start -> { F(1) turn(-0) push Leaf pop repeat(3, 9007199254740992) }
rule F -> if light > dim and season != winter or light <= -1e2 then { F(half) F(half) turn(1e-3) }
rule Leaf -> if season = summer then { Leaf }
environment dark { light = dim season = winter, }
environment bright {
  season = summer
  light = 1.5e+03
}
