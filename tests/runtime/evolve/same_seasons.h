#pragma once

// Scenarios with every pattern of physically equal and different seasons: all
// set partitions of up to four, each season of a part being the same to the
// physics under a name of its own, and told something else than its neighbours.

#include <vector>

#include "runtime/scenario/scenario.h"

namespace plsc::test {

/// The part of each season: {0, 1, 0} is "flat, tilted, flat". All partitions
/// of 1 to `seasons` seasons.
std::vector<std::vector<int>> SeasonPatterns(int seasons);

/// Seasons of eight steps. Part 0 is level ground, the others slopes; `hot`
/// alternates whatever the part.
Scenario PatternScenario(const std::vector<int>& pattern);

/// The pattern's scenario for both kinds of lives, of plasticity and of
/// sensing.
std::vector<Scenario> PatternVariants(const std::vector<int>& pattern);

}  // namespace plsc::test
