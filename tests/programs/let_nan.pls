plsc 1
alphabet plasticoding 1
let w = nan  # expect error[P1111]
