#pragma once

// TrialOptions as keys of an experiment: trials, trials_fitness, own_lives and
// noise.

#include <string>

#include "runtime/evolve/trial_options.h"

namespace plsc {

class YamlMap;

/// Reports what is wrong, also what is only wrong together.
TrialOptions ReadTrials(YamlMap& map);

/// What is otherwise than one undisturbed life a robot, in a line: "3 trials a
/// robot (fitness: median), noise: start_height 3e-05 m"; empty: nothing.
std::string DescribeTrials(const TrialOptions& options);

/// Every key, a line each, without indentation.
std::string PrintTrials(const TrialOptions& options);

}  // namespace plsc
