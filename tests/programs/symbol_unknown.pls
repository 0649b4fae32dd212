plsc 1
alphabet plasticoding 1
rule B -> { add_lefft T(0.1) }  # expect error[P2001]
rule AJ1 -> { B }  # expect error[P2001]
rule b -> { B }  # expect error[P2001]
