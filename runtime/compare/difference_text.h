#pragma once

// What changed in a genotype, and in its robots, for people: a line a change,
// marked with + (new), - (gone), ~ (another) or > (moved).

#include <string>
#include <vector>

#include "compiler/changes/written_difference.h"
#include "runtime/compare/robot_difference.h"

namespace plsc {

/// Painted as diffs are: red what is gone, green what is new, yellow the rest.
struct DifferenceStyle {
  bool in_color = false;
};

/// "~ rule 1 of C (line 11, now 12)" and what changed in it.
std::string ItemChangesText(const std::vector<ItemChange>& changes,
                            const DifferenceStyle& style = {});

/// "gecko in flat: the same" or the differences, alike environments together.
std::string RobotDifferencesText(
    const std::string& genotype,
    const std::vector<EnvironmentDifference>& environments,
    const DifferenceStyle& style = {});

/// "A1(0.5, 2 -> 3, 3, 1)"; with another name "B -> T(0.5)".
std::string PartChangeText(const PartContent& before, const PartContent& after);

}  // namespace plsc
