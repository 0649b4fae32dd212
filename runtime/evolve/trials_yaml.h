#pragma once

// TrialOptions as keys of an experiment: trials, trials_fitness, own_lives and
// noise.

#include <string>

#include "runtime/evolve/trial_options.h"

namespace plsc {

class YamlMap;

/// Reports what is wrong, also what is only wrong together.
TrialOptions ReadTrials(YamlMap& map);

/// Every key, a line each, without indentation.
std::string PrintTrials(const TrialOptions& options);

}  // namespace plsc
