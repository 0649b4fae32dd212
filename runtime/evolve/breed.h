#pragma once

// Birth: an individual made from nothing or from a population. Each has
// streams of random numbers of its own, so that nobody's birth depends on
// who was born before.

#include <vector>

#include "runtime/evolve/experiment.h"
#include "runtime/evolve/individual.h"

namespace plsc {

/// A member of the initial population, not evaluated.
Individual CreateFirst(const Experiment& experiment, int id);

/// Two different parents by tournaments on `scores` (one a member of
/// `population`, at least two members), one child, not evaluated. How parents
/// were evaluated matters where the experiment inherits more than genotypes.
Individual CreateChild(const Experiment& experiment, int generation, int id,
                       const std::vector<Individual>& population,
                       const std::vector<int>& scores);

}  // namespace plsc
