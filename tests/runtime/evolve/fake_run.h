#pragma once

// What tests of whole runs share: a small experiment whose robots are evaluated
// by a look at the phenotype instead of by physics, and an observer that keeps
// all it sees.

#include <functional>
#include <string>
#include <vector>

#include "runtime/evolve/evolve.h"
#include "runtime/life/simulated.h"

namespace plsc::test {

/// 8 parents, 6 children, 5 generations: 32 evaluations. The paper's seasons.
Experiment SmallExperiment();

/// A robot's speed from counts of modules: the flat season likes joints, the
/// tilted one touch sensors. Every eleventh body or so is unstable on the
/// slope. What is lifted is faster by a tenth of its lift a second.
Simulated Look(const Phenotype& robot, const Season& season,
               const Disturbance& disturbance = {});

/// A number of the phenotype, evenly spread.
std::uint64_t NumberOf(const Phenotype& robot);

class Recorder : public RunObserver {
 public:
  std::vector<std::vector<int>> births;  ///< ids, by generation
  /// By id from 1; those not evaluated have id 0.
  std::vector<Individual> individuals;
  std::vector<std::vector<SeasonEvidence>> evidence;  ///< by id from 1
  std::vector<int> evaluated;                         ///< ids as they came
  std::vector<GenerationRecord> generations;
  /// What OnEvaluated fails after; 0: never.
  std::size_t failing_after = 0;

  MaybeFailure OnBirths(const std::vector<Individual>& born,
                        const std::function<bool()>& should_stop) override;
  MaybeFailure OnEvaluated(const Individual& one,
                           const std::vector<SeasonEvidence>& its) override;
  MaybeFailure OnGeneration(const GenerationRecord& record) override;
};

}  // namespace plsc::test
