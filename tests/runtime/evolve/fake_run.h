#pragma once

// What tests of whole runs share: a small experiment whose robots are judged
// by a look at the genotype, and an observer that keeps all it sees.

#include <string>
#include <vector>

#include "runtime/evolve/evolve.h"

namespace plsc::test {

/// 8 parents, 6 children, 5 generations: 32 evaluations.
Experiment SmallExperiment();

/// Two seasons as SmallExperiment has, the fitness of each from counts of
/// symbols; the flat one likes joints, the tilted one touch sensors. Every
/// eleventh robot has no fitness on the slope.
Evaluation Look(const Genotype& genotype);

/// The number in "robot_17".
int IdOf(const Genotype& genotype);

class Recorder : public RunObserver {
 public:
  std::vector<Individual> individuals;
  std::vector<GenerationRecord> generations;
  /// Id at which OnEvaluated fails; 0: never.
  int failing_id = 0;

  std::optional<std::string> OnBirths(
      const std::vector<Individual>& born) override;
  std::optional<std::string> OnEvaluated(
      const Individual& one,
      const std::vector<SeasonEvidence>& evidence) override;
  std::optional<std::string> OnGeneration(
      const GenerationRecord& record) override;
};

}  // namespace plsc::test
