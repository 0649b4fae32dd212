plsc 1
alphabet plasticoding 1
rulle B -> {  # expect error[P1101]
  add_left
  T(0.1)
}
rule B -> { T(0.2) }
