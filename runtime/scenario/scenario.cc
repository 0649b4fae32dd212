#include "runtime/scenario/scenario.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/environment_text.h"
#include "grammar/reporter.h"

namespace plsc {

namespace {

Diagnostic SenseError(const Season& season, const State& state,
                      const std::string& found, std::string help) {
  return Diagnostic(
             Code::kMisfit, {},
             fmt::format("season '{}': expected {} for state '{}', found {}",
                         season.name, ExpectedValue(state), state.name, found))
      .WithHelp(std::move(help));
}

}  // namespace

Result<Environment> Sense(const Season& season,
                          const std::vector<State>& states,
                          const std::map<std::string, std::string>& felt) {
  Environment environment;
  Reporter errors;
  for (const State& state : states) {
    const auto given = season.senses.find(state.name);
    const auto own = felt.find(state.name);
    const bool is_given = given != season.senses.end();
    if (!is_given && own == felt.end()) {
      errors.Add(SenseError(
          season, state, "nothing",
          fmt::format("add '{}' to the senses of the season", state.name)));
      continue;
    }
    const std::string& text = is_given ? given->second : own->second;
    if (const auto value = ParseStateValue(text, state))
      environment.values.push_back(*value);
    else
      errors.Add(SenseError(season, state, fmt::format("'{}'", text), ""));
  }
  if (errors.has_errors()) return errors.Take();
  return environment;
}

bool IsFelt(const Scenario& scenario, const Season& season,
            const State& state) {
  return scenario.sensing == Sensing::kImu && state.name == "inclined" &&
         state.type == StateType::kBool && !season.senses.contains(state.name);
}

std::vector<Diagnostic> CheckSenses(const Scenario& scenario,
                                    const std::vector<State>& states) {
  Reporter errors;
  // Without senses of its own a season feels all that can be felt.
  std::vector<State> not_felt;
  for (const State& state : states)
    if (!IsFelt(scenario, {}, state)) not_felt.push_back(state);
  for (const Season& season : scenario.seasons) {
    if (errors.is_full()) break;
    const bool feels = std::any_of(
        states.begin(), states.end(),
        [&](const State& state) { return IsFelt(scenario, season, state); });
    const Result<Environment> sensed = Sense(season, feels ? not_felt : states);
    if (!sensed)
      for (const Diagnostic& error : sensed.diagnostics()) errors.Add(error);
  }
  return errors.Take();
}

Scenario WithoutFitness(Scenario scenario) {
  for (Season& season : scenario.seasons) season.fitness.reset();
  return scenario;
}

std::optional<Diagnostic> CheckEngines(const Scenario& scenario) {
  for (const Season& season : scenario.seasons)
    if (season.physics.engine == EngineKind::kArticulated &&
        season.physics.solver == Solver::kIterative)
      return Diagnostic(
                 Code::kMisfit, {},
                 fmt::format("season '{}' asks for 'solver: iterative', which "
                             "the articulated engine has not",
                             season.name))
          .WithHelp(
              "write 'solver: direct' (its method is exact, and as fast), or "
              "'engine: ode'");
  if (scenario.lives != Lives::kContinuous) return std::nullopt;
  const auto other = std::find_if(
      scenario.seasons.begin(), scenario.seasons.end(),
      [&](const Season& season) {
        return season.physics.engine != scenario.seasons[0].physics.engine;
      });
  if (other == scenario.seasons.end()) return std::nullopt;
  return Diagnostic(Code::kMisfit, {},
                    fmt::format("seasons '{}' and '{}' are one life (lives: "
                                "continuous), but of two engines",
                                scenario.seasons[0].name, other->name))
      .WithHelp("give all seasons of a continuous life the same 'engine'");
}

std::optional<Diagnostic> SetEngine(Scenario& scenario, EngineKind engine) {
  for (Season& season : scenario.seasons) season.physics.engine = engine;
  return CheckEngines(scenario);
}

bool UsesOde(const Scenario& scenario) {
  return std::any_of(scenario.seasons.begin(), scenario.seasons.end(),
                     [](const Season& season) {
                       return season.physics.engine == EngineKind::kOde;
                     });
}

SimulationOptions OptionsFor(const Scenario& scenario, const Season& season) {
  SimulationOptions options;
  options.duration = season.duration;
  options.sample_interval = scenario.sample_interval;
  options.start_height = season.start_height;
  options.start_clearance = scenario.start_clearance;
  options.controller = scenario.controller;
  options.max_steps = scenario.max_steps;
  options.max_links = scenario.max_links;
  options.physics = season.physics;
  options.servo = scenario.servo;
  return options;
}

}  // namespace plsc
