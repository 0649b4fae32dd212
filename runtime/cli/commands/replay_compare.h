#pragma once

// Two evaluations of one robot, the stored one and a new one, compared number
// by number.

#include <cstddef>
#include <string>
#include <vector>

#include "runtime/evolve/individual.h"
#include "runtime/life/life_plan.h"

namespace plsc::cli {

struct Difference {
  std::string season;
  std::string name;  ///< of the value, "displacement_velocity_hill"
  std::string stored;
  std::string now;
};

struct Replayed {
  int id = 0;
  std::size_t seasons = 0;
  std::size_t values = 0;  ///< compared
  std::vector<Difference> differences;
};

/// Bit for bit, but that -0 and 0 are equal: a store keeps no sign of zero.
/// Without keys of simulations: those of other arithmetic are all other ones.
Replayed Compare(const Individual& stored,
                 const std::vector<SeasonEvidence>& evidence,
                 const EvaluatedLife& now, bool with_keys = true);

}  // namespace plsc::cli
