#pragma once

// The trials of a robot for people: each life of each season, how it was
// disturbed and what came of it.

#include <string>
#include <vector>

#include "runtime/evolve/experiment.h"
#include "runtime/store/trial_rows.h"

namespace plsc::cli {

/// `trials` by season, as TrialRows finds them; empty if there are none.
std::string TrialsText(const Experiment& experiment,
                       const std::vector<std::vector<StoredTrial>>& trials);

}  // namespace plsc::cli
