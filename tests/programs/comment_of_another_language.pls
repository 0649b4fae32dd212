plsc 1
alphabet plasticoding 1
// rule B -> { B }  # expect error[P1104]
rule C -> {
  C // core  # expect error[P1104]
}
