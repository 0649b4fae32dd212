#pragma once

// Whoever wants to know what happens in a run: the store, a test. Births of a
// generation come first, all together; then its evaluations as they end, in
// any order; then what became of the generation.

#include <functional>
#include <string>
#include <vector>

#include "grammar/failure.h"
#include "runtime/evolve/individual.h"
#include "runtime/life/life_plan.h"

namespace plsc {

/// What became of one generation. The domination counts are of the pool:
/// parents and children, or the initial population.
struct GenerationRecord {
  int generation = 0;
  std::vector<int> pool;       ///< ids
  std::vector<int> counts;     ///< of the pool, in its order
  std::vector<int> survivors;  ///< ids, in the order of selection
  int best = 0;                ///< id, as RunResult::best

  friend bool operator==(const GenerationRecord&,
                         const GenerationRecord&) = default;
};

/// What a function returns is what went wrong, which ends the run; or nothing.
class RunObserver {
 public:
  virtual ~RunObserver() = default;
  /// A generation's newborn in order of id, not evaluated yet. A run that goes
  /// on shows those of the generation that was under way again. When
  /// `should_stop`, if any, says so, which ends the run, it may come back as if
  /// it had never been called.
  virtual MaybeFailure OnBirths(const std::vector<Individual>& born,
                                const std::function<bool()>& should_stop) = 0;
  /// Everybody once, in the order in which evaluations end; `evidence` has an
  /// item a season. Not those that were evaluated before the run went on.
  virtual MaybeFailure OnEvaluated(
      const Individual& one, const std::vector<SeasonEvidence>& evidence) = 0;
  virtual MaybeFailure OnGeneration(const GenerationRecord& record) = 0;
};

}  // namespace plsc
