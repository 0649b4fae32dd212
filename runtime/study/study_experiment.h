#pragma once

// One of the experiments that a study compares.

#include <string>

#include "runtime/evolve/experiment.h"

namespace plsc {

struct StudyExperiment {
  std::string name;  ///< also of its folder
  /// Its `name` and `seed` mean nothing; ExperimentOf sets them.
  Experiment experiment;

  friend bool operator==(const StudyExperiment&,
                         const StudyExperiment&) = default;
};

}  // namespace plsc
