#pragma once

// A scenario's part of a YAML file, for runtime/scenario and for experiments
// that have their scenario inline.

#include <string>

#include "runtime/scenario/scenario.h"
#include "runtime/text/yaml_reader.h"

namespace plsc {

/// Reads and closes the map; what is wrong is reported in its file, and
/// replaced by a default.
Scenario ReadScenario(YamlMap& map);

/// The keys of a scenario, every line indented by `indent` blanks.
std::string PrintScenarioKeys(const Scenario& scenario, int indent);

}  // namespace plsc
