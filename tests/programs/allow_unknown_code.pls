plsc 1
alphabet plasticoding 1
# plsc: allow W9999  # expect warning[W1001]
rule C -> { C add_left B }
