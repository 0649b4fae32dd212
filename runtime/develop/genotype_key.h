#pragma once

// A name for what a genotype says: equal for texts that differ in comments,
// layout, how numbers are written, constants, the order of items that has no
// meaning, and the genotype's own name.

#include "compiler/genotype.h"
#include "runtime/text/key.h"

namespace plsc {

/// States and the values of enums sorted by name, as their order means nothing
/// to any robot. The order of rules of one symbol does (they are joined), as
/// does that of terms and symbols, which mutations count.
Genotype Canonical(Genotype genotype);

/// Of the canonical genotype's printed text without its name.
Key GenotypeKey(const Genotype& genotype);

}  // namespace plsc
