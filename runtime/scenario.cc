#include "runtime/scenario.h"

#include <fmt/format.h>

#include <numbers>

#include "runtime/environment.h"
#include "runtime/scenario_yaml.h"

namespace plsc {

namespace {

constexpr int kFormat = 1;  // of scenario files, the value of plsc_scenario

Diagnostic SenseError(const Season& season, const State& state,
                      const std::string& found, std::string help) {
  Diagnostic error;
  error.code = "P5108";
  error.message =
      fmt::format("season '{}': expected {} for state '{}', found {}",
                  season.name, ExpectedValue(state), state.name, found);
  error.help = std::move(help);
  return error;
}

}  // namespace

Scenario PaperScenario() {
  Season flat;
  flat.name = "flat";
  flat.start_height = kFlatStartHeight;
  flat.senses = {{"inclined", "False"}, {"hot", "False"}};
  Season tilted;
  tilted.name = "tilted";
  tilted.terrain = {TerrainType::kTilted, 5 * std::numbers::pi / 180};
  tilted.start_height = kTiltedStartHeight;
  tilted.senses = {{"inclined", "True"}, {"hot", "False"}};
  Scenario scenario;
  scenario.name = "paper";
  scenario.seasons = {flat, tilted};
  return scenario;
}

Result<Scenario> ParseScenario(const Source& yaml) {
  const YamlFile file(yaml);
  Scenario scenario;
  if (std::optional<YamlMap> root = file.Root("a scenario")) {
    root->Int("plsc_scenario", kFormat, kFormat, kFormat);
    scenario = ReadScenario(*root);
  }
  if (!file.diagnostics().empty()) return file.diagnostics();
  return scenario;
}

std::string PrintScenario(const Scenario& scenario) {
  return fmt::format("plsc_scenario: {}\n{}", kFormat,
                     PrintScenarioKeys(scenario, 0));
}

Result<Environment> Sense(const Season& season,
                          const std::vector<State>& states) {
  Environment environment;
  std::vector<Diagnostic> errors;
  for (const State& state : states) {
    const auto sensed = season.senses.find(state.name);
    if (sensed == season.senses.end())
      errors.push_back(SenseError(
          season, state, "nothing",
          fmt::format("add '{}' to the senses of the season", state.name)));
    else if (const auto value = ParseStateValue(sensed->second, state))
      environment.values.push_back(*value);
    else
      errors.push_back(
          SenseError(season, state, fmt::format("'{}'", sensed->second), ""));
  }
  if (!errors.empty()) return errors;
  return environment;
}

}  // namespace plsc
