plsc 1
alphabet plasticoding 1
sense hot: bool
sense slope: real in 0..45
environment a { hot = True }  # expect error[P2015]
environment b { hot = True, slope = 50 }  # expect error[P2015]
environment c { hot = True, hot = False, slope = 5 }  # expect error[P2015]
environment d { slope = 5 hot = maybe }  # expect error[P2006]
