#pragma once

// Fresh random parts of genotypes, as initialisation and mutation both need
// them (paper, "Initialization" and Table 1): symbols with arguments, terms of
// clauses. Never draws the core C, which only stands at the start of rules of
// C.

#include <vector>

#include "compiler/genotype.h"
#include "runtime/vary/rng.h"

namespace plsc {

/// Uniform among the symbols of the category without C, fresh arguments by
/// the alphabet's sampling.
Symbol DrawSymbol(const Alphabet& alphabet, Category category, Rng& rng);

/// A state uniformly, then DrawComparison. `states` is not empty.
Term DrawTerm(const std::vector<State>& states, Rng& rng);

/// Bool: = with True or False. Enum: = or !=, with a value, both uniform.
/// Real: <, <=, > or >= uniformly (a real equals a number hardly ever), with
/// a number uniform in the state's range. Only bool is the paper's.
Term DrawComparison(const std::vector<State>& states, StateId id, Rng& rng);

Connective DrawConnective(Rng& rng);  ///< and, or

}  // namespace plsc
