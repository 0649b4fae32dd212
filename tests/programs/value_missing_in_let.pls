plsc 1
alphabet plasticoding 1
let w0 = fast  # expect error[P1108]
