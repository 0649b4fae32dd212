#pragma once

// Where a run stood when it was left, all that is needed to go on: there is no
// state of random numbers, because every stream is named by who needs it
// (runtime/vary/rng.h).

#include <cstdint>
#include <map>
#include <vector>

#include "runtime/evolve/individual.h"

namespace plsc {

struct SavedRun {
  int generations = 0;  ///< completed, the initial one included
  /// Survivors of the last one, evaluated, in the order of selection, and the
  /// domination counts that they survived with.
  std::vector<Individual> population;
  std::vector<int> counts;
  /// By id: those of the generation under way that are evaluated already. Whose
  /// worker died is not: such a life depends on more than the experiment, and
  /// as long as nothing was selected by it, it can be lived anew.
  std::map<int, Evaluation> evaluated;
  std::int64_t evaluations = 0;  ///< of the whole run so far
};

}  // namespace plsc
