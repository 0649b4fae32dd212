{<Alphabet.CORE_COMPONENT: 'C'>: [[<Alphabet.CORE_COMPONENT: 'C'>, []]]}  # expect error[P5012]
