plsc 1
alphabet plasticoding 1
sense hot: bool
sense temperature: real in -40..60
sense ground: { dry, wet }
rule C -> if temperature = True then { C }  # expect error[P2006]
rule C -> if hot = 1 then { C }  # expect error[P2006]
rule C -> if hot < True then { C }  # expect error[P2006]
rule C -> if ground = True then { C }  # expect error[P2006]
rule C -> if ground = wett then { C }  # expect error[P2006]
rule C -> if ground >= wet then { C }  # expect error[P2006]
