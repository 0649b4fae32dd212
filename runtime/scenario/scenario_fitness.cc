// A season whose formula is the default has none: scenarios that mean the same
// are equal, whether they say so or not.

#include "runtime/scenario/scenario_fitness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "grammar/suggest.h"
#include "runtime/formula/formula_yaml.h"
#include "runtime/formula/quantities.h"
#include "runtime/formula/read_formula.h"
#include "runtime/text/yaml_reader.h"
#include "runtime/text/yaml_text.h"

namespace plsc {

namespace {

// Each is drawn, and its distance is found after each season.
constexpr std::size_t kMaxTargets = 100;
// m: beyond what any robot comes to.
constexpr Quantity kPlace = {Dimension::kLength, -1e4, 1e4, false, 1.0};

std::optional<Formula> ReadOwn(const YamlValue& value) {
  std::optional<Formula> formula = ReadFormula(value);
  if (formula && *formula == DefaultFitness()) formula.reset();
  return formula;
}

void ReadBySeason(YamlMap map, Scenario& scenario) {
  std::vector<std::string_view> names;
  for (const Season& season : scenario.seasons) names.push_back(season.name);
  for (const YamlMap::Entry& entry : map.TakeAll()) {
    const auto season =
        std::find_if(scenario.seasons.begin(), scenario.seasons.end(),
                     [&](const Season& one) { return one.name == entry.key; });
    if (season != scenario.seasons.end()) {
      season->fitness = ReadOwn(entry.value);
      continue;
    }
    const auto near = Suggest(entry.key, names);
    entry.at.Report(Code::kUnknownWord,
                    fmt::format("expected a season, found '{}'", entry.key),
                    near ? fmt::format("did you mean '{}'?", *near)
                         : fmt::format("there are {}", fmt::join(names, ", ")),
                    near.value_or(""));
  }
}

std::string TextOf(const Season& season) {
  return PrintFormula(season.fitness ? *season.fitness : DefaultFitness());
}

bool IsShared(const Scenario& scenario) {
  return std::all_of(scenario.seasons.begin(), scenario.seasons.end(),
                     [&](const Season& one) {
                       return one.fitness == scenario.seasons.front().fitness;
                     });
}

}  // namespace

const Formula& DefaultFitness() {
  static const Formula formula = [] {
    Result<Formula> read = ReadFormula(kDefaultFitness);
    assert(read);
    return std::move(*read);
  }();
  return formula;
}

bool HasOwnFitness(const Scenario& scenario) {
  return std::any_of(scenario.seasons.begin(), scenario.seasons.end(),
                     [](const Season& one) { return one.fitness.has_value(); });
}

void ReadFitness(const YamlValue& value, Scenario& scenario) {
  if (value.is_map()) return ReadBySeason(*value.Map("fitness"), scenario);
  const std::optional<Formula> formula = ReadOwn(value);
  for (Season& season : scenario.seasons) season.fitness = formula;
}

std::string PrintFitness(const Scenario& scenario, const std::string& blanks) {
  if (scenario.seasons.empty()) return "";
  if (IsShared(scenario))
    return fmt::format("{}fitness: {}\n", blanks,
                       PrintYamlText(TextOf(scenario.seasons.front())));
  std::string text = blanks + "fitness:\n";
  for (const Season& season : scenario.seasons)
    text += fmt::format("{}  {}: {}\n", blanks, PrintYamlText(season.name),
                        PrintYamlText(TextOf(season)));
  return text;
}

std::string DescribeFitness(const Scenario& scenario) {
  if (scenario.seasons.empty()) return "";
  if (IsShared(scenario)) return TextOf(scenario.seasons.front());
  std::vector<std::string> parts;
  for (const Season& season : scenario.seasons)
    parts.push_back(season.name + ": " + TextOf(season));
  return fmt::format("{}", fmt::join(parts, ", "));
}

void ReadTargets(YamlMap& map, Scenario& scenario) {
  const auto value = map.Find("targets");
  if (!value) return;
  const auto items = value->List("targets, as in [{x: 1 m, y: 2 m}]");
  if (!items) return;
  if (items->size() > kMaxTargets)
    return value->Report(Code::kMisfit,
                         fmt::format("a scenario has at most {} targets, "
                                     "found {}",
                                     kMaxTargets, items->size()));
  for (const YamlValue& item : *items) {
    std::optional<YamlMap> place = item.Map("a target, as in {x: 1 m, y: 2 m}");
    if (!place) continue;
    Target target;
    target.x = place->Number("x", 0, kPlace);
    target.y = place->Number("y", 0, kPlace);
    place->Close();
    scenario.targets.push_back(target);
  }
}

std::string PrintTargets(const std::vector<Target>& targets) {
  std::vector<std::string> items;
  items.reserve(targets.size());
  for (const Target& target : targets)
    items.push_back(fmt::format("{{x: {}, y: {}}}",
                                PrintQuantity(target.x, Dimension::kLength),
                                PrintQuantity(target.y, Dimension::kLength)));
  return fmt::format("[{}]", fmt::join(items, ", "));
}

std::optional<Diagnostic> CheckTargets(const Scenario& scenario) {
  constexpr std::string_view kDistance = "target_distance";
  if (!scenario.targets.empty()) return std::nullopt;
  const std::size_t distance = *FindQuantity(kDistance);
  for (const Season& season : scenario.seasons)
    if (season.fitness && season.fitness->Uses(distance))
      return Diagnostic(
                 Code::kMisfit, {},
                 fmt::format("the fitness of season '{}' asks for {}, and "
                             "there are no targets",
                             season.name, kDistance))
          .WithHelp("add 'targets: [{x: 1 m, y: 2 m}]' to the scenario");
  return std::nullopt;
}

}  // namespace plsc
