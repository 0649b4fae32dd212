plsc 1
alphabet plasticoding 1
sense ground: { dry, wet }
rule B -> if ground = dry and ground = wet then { B }  # expect warning[W3002]
