plsc 1
alphabet plasticodng 1  # expect error[P2010]
rule Whatever -> { anything }
