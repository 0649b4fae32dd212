#include "runtime/service/subject.h"

#include <fmt/format.h>

#include <utility>

#include "compiler/named_environments.h"
#include "grammar/suggest.h"
#include "runtime/advice/lint.h"
#include "runtime/develop/growth.h"
#include "runtime/life/season_environments.h"
#include "runtime/scenario/scenario_physics.h"
#include "runtime/scenario/scenario_profile.h"
#include "runtime/scenario/scenario_yaml.h"
#include "runtime/service/limits.h"
#include "runtime/service/refusal.h"

namespace plsc::service {

namespace {

std::string Limited(std::string text, std::string_view key, std::size_t most) {
  if (text.size() > most)
    throw Refusal(
        fmt::format("'{}' has {} bytes, more than {}", key, text.size(), most));
  return text;
}

/// The one of that name; the first without a name.
std::size_t Choose(const std::vector<MappedProgram>& all,
                   const std::string& name, const Source& source) {
  if (name.empty()) return 0;
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < all.size(); ++i) {
    names.push_back(all[i].program.genotype.name);
    if (names.back() == name) return i;
  }
  const auto near = Suggest(name, names);
  throw Refusal(fmt::format("{} has no genotype '{}'{}", source.name(), name,
                            near ? "; did you mean '" + *near + "'?" : ""));
}

std::vector<NamedEnvironment> InSeasons(const Request& request,
                                        const Subject& subject) {
  const Scenario scenario = ScenarioOf(request);
  if (!CheckSenses(scenario, subject.genotype().states).empty())
    throw Refusal(fmt::format(
        "which environment? the text names none, and the scenario does not "
        "give all that is sensed; say it as {}",
        ExampleOfEnvironment(subject.genotype().states)));
  RefuseMissingEngine(scenario);
  return SeasonEnvironments(subject.genotype(), scenario);
}

/// Whoever feels the ground is put down on it, which is simulated.
void RefuseLongSettling(const Scenario& scenario) {
  double steps = 0;
  for (const Season& season : scenario.seasons)
    steps += scenario.imu.settling / season.physics.step;
  if (steps > kMostLinkSteps)
    throw Refusal(fmt::format(
        "to settle before they feel the ground takes robots {:.3g} steps in "
        "this scenario, more than {:.3g}",
        steps, kMostLinkSteps));
}

}  // namespace

std::string LimitedText(const Request& request, std::string_view key,
                        std::size_t most) {
  return Limited(request.Text(key), key, most);
}

std::string NameOf(const Request& request) {
  return Limited(request.Text("name", "robot.pls"), "name", kMostNameBytes);
}

Source TextOf(const Request& request) {
  return {NameOf(request), LimitedText(request, "text")};
}

Subject SubjectOf(const Request& request) {
  Source source = TextOf(request);
  auto all = CompileAllWithMap(source);
  if (!all) throw Refusal(all.diagnostics(), source);
  const std::size_t chosen = Choose(*all, request.Text("genotype", ""), source);
  return {std::move(source), std::move((*all)[chosen]), all.diagnostics()};
}

Scenario ScenarioOf(const Request& request) {
  Scenario scenario = BothSeasons(Profile::kSwift);
  if (request.Has("scenario")) {
    const Source yaml(kScenarioName,
                      LimitedText(request, "scenario", kMostScenarioBytes));
    Result<Scenario> read = ParseScenario(yaml);
    if (!read) throw Refusal(read.diagnostics(), yaml);
    scenario = std::move(*read);
  }
  if (scenario.seasons.size() > kMostEnvironments)
    throw Refusal(fmt::format("the scenario has {} seasons, more than {}",
                              scenario.seasons.size(), kMostEnvironments));
  if (request.Has("engine")) {
    const auto engine = ValueIn(kEngineNames, request.Text("engine"));
    if (!engine)
      throw Refusal(fmt::format("expected 'engine' to be one of {}",
                                fmt::join(AllNames(kEngineNames), ", ")));
    if (const auto problem = SetEngine(scenario, *engine))
      throw Refusal(problem->message);
  }
  RefuseLongSettling(scenario);
  return scenario;
}

std::vector<NamedEnvironment> EnvironmentsOf(const Request& request,
                                             const Subject& subject) {
  const Program& program = subject.mapped.program;
  std::vector<NamedEnvironment> environments;
  const std::vector<std::string> texts = request.Texts("environment");
  for (const std::string& text : texts) {
    if (environments.size() == kMostEnvironments) break;
    const Source source("environment", text);
    Result<NamedEnvironment> found = FindEnvironment(program, source);
    if (!found) throw Refusal(found.diagnostics(), source);
    environments.push_back(std::move(*found));
  }
  const std::size_t count = std::max(texts.size(), program.environments.size());
  if (count > kMostEnvironments)
    throw Refusal(fmt::format("expected at most {} environments, not {}",
                              kMostEnvironments, count));
  if (!texts.empty()) return environments;
  if (auto usual = UsualEnvironments(program)) return std::move(*usual);
  return InSeasons(request, subject);
}

void RefuseMissingEngine(const Scenario& scenario) {
  if (UsesOde(scenario) && !HasOde())
    throw Refusal(
        "the scenario's robots live in ODE, which a page has not; ask with "
        "'engine': 'articulated', or write 'profile: swift'");
}

void RefuseBodiless(const Genotype& genotype, const char* purpose) {
  if (!genotype.alphabet->is_built_in())
    throw Refusal(fmt::format("alphabet '{}' has no bodies to {}",
                              genotype.alphabet->name(), purpose));
}

void RefuseGrowth(const Subject& subject,
                  const std::vector<NamedEnvironment>& environments) {
  std::uint64_t symbols = 0;
  for (const NamedEnvironment& named : environments) {
    const ActiveRules active = Regulate(subject.genotype(), named.environment);
    const std::uint64_t length = DerivedLength(subject.genotype(), active);
    if (length > kMaxStringLength)
      throw Refusal({GrowthError(subject.mapped, active, length, named.name)},
                    subject.source);
    symbols += length;
    if (symbols > kMostSymbols)
      throw Refusal(fmt::format(
          "in {}, {} symbols have been developed, more than {} of one request",
          named.name, symbols, kMostSymbols));
  }
}

}  // namespace plsc::service
