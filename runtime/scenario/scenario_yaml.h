#pragma once

// Scenarios as YAML: files of their own, and the part of a file that
// experiments have inline.

#include <string>

#include "runtime/scenario/scenario.h"
#include "runtime/text/yaml_reader.h"

namespace plsc {

/// Unknown keys, wrong types and wrong units are errors with their place.
/// `otherwise`: the profile of a text that names none.
Result<Scenario> ParseScenario(const Source& yaml,
                               Profile otherwise = Profile::kPaper);

/// The whole scenario as YAML, every constant written out; ParseScenario
/// returns an equal one.
std::string PrintScenario(const Scenario& scenario);

/// Reads and closes the map; what is wrong is reported in its file, and
/// replaced by a default.
Scenario ReadScenario(YamlMap& map, Profile otherwise = Profile::kPaper);

/// The keys of a scenario, every line indented by `indent` blanks.
std::string PrintScenarioKeys(const Scenario& scenario, int indent);

}  // namespace plsc
