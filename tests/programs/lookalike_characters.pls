plsc 1
alphabet plasticoding 1
# Of a word processor: a minus sign, a no-break space, a zero width space.
let x = −0.5  # expect error[P1119]
rule B -> {  # “comments may have any”
  add_​left  # expect error[P1119]
}
