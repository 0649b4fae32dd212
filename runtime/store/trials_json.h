#pragma once

// Trials as JSON: of each season the list of its lives.

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "runtime/store/trial_rows.h"

namespace plsc {

/// `trials` by season, as TrialRows finds them.
nlohmann::ordered_json TrialsJson(
    const std::vector<std::vector<StoredTrial>>& trials);

}  // namespace plsc
