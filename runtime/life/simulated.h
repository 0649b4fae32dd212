#pragma once

// What is known of a season only when it is simulated. All else of a
// SeasonResult follows from the genotype and from what was felt
// (runtime/life/life_plan), so this is what a store of simulations keeps.

#include <cstdint>
#include <optional>
#include <string>

#include "sim/measures.h"
#include "sim/outcome.h"

namespace plsc {

struct Simulated {
  double begin = 0;  ///< s since birth
  /// rad, of the core when the season began, if its IMU was asked.
  std::optional<double> inclination;
  Outcome outcome = Outcome::kCompleted;
  std::string reason;  ///< of the outcome; empty when completed
  Behaviour behaviour;
  std::uint64_t state_hash = 0;  ///< of the final physical state
  std::int64_t steps = 0;
  int solver_warnings = 0;
};

}  // namespace plsc
