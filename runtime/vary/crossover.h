#pragma once

// Crossover (paper, "Crossover"): of each symbol, all rules with their clauses
// come from one of the two parents.

#include <vector>

#include "compiler/genotype.h"
#include "runtime/vary/rng.h"

namespace plsc {

/// For every replaceable symbol, in table order: its rules come from the
/// second parent. Each with probability 1/2.
std::vector<bool> DrawCrossover(const Alphabet& alphabet, Rng& rng);

/// All else (states, limits, settings) is the first parent's. The parents have
/// equal alphabets and equal states. Without a name.
Genotype Cross(const Genotype& first, const Genotype& second,
               const std::vector<bool>& from_second);

}  // namespace plsc
