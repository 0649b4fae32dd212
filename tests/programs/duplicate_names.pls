plsc 1
alphabet mine {
  replaceable X, Y;
  terminal X  # expect error[P2017]
  terminal a(t: int, t: int)  # expect error[P2017]
}
axiom X
sense hot: bool
sense hot: bool  # expect error[P2017]
let w = 1
let w = 2  # expect error[P2017]
environment e { hot = True }
environment e { hot = True }  # expect error[P2017]
