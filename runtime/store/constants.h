#pragma once

// Every constant that a season is simulated with, as rows of a table. Read
// back from the scenario as PrintScenario writes it, so that a constant that
// is new there is stored, too.

#include <optional>
#include <string>
#include <vector>

#include "runtime/scenario/scenario.h"
#include "runtime/scenario/scenario_yaml.h"

namespace plsc {

struct ScenarioConstant {
  std::string name;  ///< the keys on the way to it: "physics.step"
  std::string text;  ///< "0.005", "direct"
  /// What the text says, if it is a number, and in which unit ("s").
  std::optional<double> number;
  std::optional<std::string> unit;
};

/// Of the season, its own and those that all share, in PrintScenario's order.
std::vector<ScenarioConstant> ConstantsOf(const Scenario& scenario,
                                          const Season& season);

}  // namespace plsc
