#pragma once

// What seasons are worth, in YAML: `fitness: speed - 0.01 * energy` for all, or
// a formula by season, and `targets: [{x: 1 m, y: 2 m}]`.

#include <optional>
#include <string>
#include <string_view>

#include "runtime/scenario/scenario.h"

namespace plsc {

class YamlMap;
class YamlValue;

/// The authors' program's (fitness.py:65-81; paper, Eq. 2), m/s: what cannot
/// move, or does not, is worth less than any slide down a slope; going back
/// counts a tenth.
inline constexpr std::string_view kDefaultFitness =
    "hinge_count == 0 or speed == 0 ? -0.1 : speed > 0 ? speed : speed * 0.1";

const Formula& DefaultFitness();

/// Whether any season is worth something else.
bool HasOwnFitness(const Scenario& scenario);

/// The seasons' names must be known. What is wrong is reported at its place.
void ReadFitness(const YamlValue& value, Scenario& scenario);

/// "fitness: ..." for all seasons, or a line each, with the line's end.
std::string PrintFitness(const Scenario& scenario, const std::string& blanks);

/// All that seasons share in one line: "speed - energy", "flat: speed, tilted:
/// energy".
std::string DescribeFitness(const Scenario& scenario);

void ReadTargets(YamlMap& map, Scenario& scenario);
/// "[{x: 1 m, y: 2 m}]"
std::string PrintTargets(const std::vector<Target>& targets);

/// A formula asks for the distance to targets, and there are none.
std::optional<Diagnostic> CheckTargets(const Scenario& scenario);

}  // namespace plsc
