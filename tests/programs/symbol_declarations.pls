plsc 1
alphabet mine {
  replaceable X
  terminal a(p: real, q: real, r: real, s: real, t: real)  # expect error[P2018]
  terminal b(p: int in 0..1.5)  # expect error[P2018]
  terminal c(p: real in 2..1)  # expect error[P2018]
}
axiom X
