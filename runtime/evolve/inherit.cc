#include "runtime/evolve/inherit.h"

#include <optional>
#include <utility>
#include <vector>

#include "runtime/environment.h"
#include "runtime/regulate.h"

namespace plsc {

namespace {

/// Nothing if a state is missing.
std::optional<Environment> EnvironmentOf(
    const std::map<std::string, std::string>& senses,
    const std::vector<State>& states) {
  Environment environment;
  for (const State& state : states) {
    const auto sensed = senses.find(state.name);
    if (sensed == senses.end()) return std::nullopt;
    const std::optional<double> value = ParseStateValue(sensed->second, state);
    if (!value) return std::nullopt;
    environment.values.push_back(*value);
  }
  return environment;
}

}  // namespace

std::map<std::string, std::string> LastSenses(const Individual& parent) {
  std::map<std::string, std::string> senses;
  const std::vector<SeasonResult>& seasons = parent.evaluation.seasons;
  for (auto season = seasons.rbegin(); season != seasons.rend(); ++season) {
    for (const SensedState& state : season->sensed)
      senses[state.name] = state.value;
    if (!senses.empty()) break;
  }
  return senses;
}

Genotype WithJoinedRules(Genotype genotype, const Environment& environment) {
  const ActiveRules active = Regulate(genotype, environment);
  std::vector<std::pair<RuleIndex, std::vector<Symbol>>> grown;
  for (const SymbolRules& symbol : BySymbol(genotype, active)) {
    if (symbol.active.size() < 2) continue;
    std::vector<Symbol> production;
    for (const Occurrence& occurrence :
         active.joined[static_cast<std::size_t>(symbol.symbol)])
      production.push_back(
          genotype.rules[occurrence.rule].production[occurrence.position]);
    grown.emplace_back(symbol.active.front(), std::move(production));
  }
  for (auto& [rule, production] : grown)
    genotype.rules[rule].production = std::move(production);
  return genotype;
}

Genotype HandedDown(const Individual& parent, Inheritance inheritance) {
  if (inheritance != Inheritance::kJoined) return parent.genotype;
  const std::optional<Environment> last =
      EnvironmentOf(LastSenses(parent), parent.genotype.states);
  return last ? WithJoinedRules(parent.genotype, *last) : parent.genotype;
}

}  // namespace plsc
