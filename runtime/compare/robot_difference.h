#pragma once

// What a change of a genotype did to its robots: body and brain in one
// environment after another, compared part by part
// (runtime/compare/robot_parts.h). Of alphabets without bodies the string is
// compared.

#include <vector>

#include "runtime/compare/environment_pairs.h"
#include "runtime/compare/golden_compare.h"

namespace plsc {

struct EnvironmentDifference {
  SharedEnvironment where;
  std::vector<Difference> differences;  ///< empty: the same robot
};

/// One for each environment, in order.
std::vector<EnvironmentDifference> CompareRobots(
    const std::vector<SharedEnvironment>& environments, const Genotype& before,
    const Genotype& after);

/// The environments of equal differences together, the first one first.
using DifferenceGroup = std::vector<const EnvironmentDifference*>;
std::vector<DifferenceGroup> GroupAlike(
    const std::vector<EnvironmentDifference>& environments);

}  // namespace plsc
