// The authors' program joined active rules inside the parent's own genotype,
// and the last season's were inherited (decision 1). It is an option here,
// kJoined, and done on a copy: the first active rule of each symbol becomes
// what Regulate joins of all. Collected first and put in place afterwards,
// because joined productions may refer to rules that change.

#include "runtime/evolve/inherit.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "runtime/develop/regulate.h"
#include "runtime/life/season_developer.h"

namespace plsc {

namespace {

/// Nothing is sensed in seasons that were not reached.
const SeasonResult* LastReached(const Individual& parent) {
  const std::vector<SeasonResult>& seasons = parent.evaluation.seasons;
  const auto last = std::find_if(
      seasons.rbegin(), seasons.rend(),
      [](const SeasonResult& season) { return !season.sensed.empty(); });
  return last == seasons.rend() ? nullptr : &*last;
}

}  // namespace

Senses LastSenses(const Individual& parent) {
  Senses senses;
  if (const SeasonResult* season = LastReached(parent))
    for (const SensedState& state : season->sensed)
      senses[state.name] = state.value;
  return senses;
}

Genotype WithJoinedRules(Genotype genotype, const Environment& environment) {
  const ActiveRules active = Regulate(genotype, environment);
  std::vector<std::pair<RuleIndex, std::vector<Symbol>>> grown;
  for (const SymbolRules& symbol : BySymbol(genotype, active)) {
    if (symbol.active.size() < 2) continue;
    std::vector<Symbol> production;
    for (const Occurrence& occurrence : active.joined[symbol.symbol])
      production.push_back(SymbolAt(genotype, occurrence));
    grown.emplace_back(symbol.active.front(), std::move(production));
  }
  for (auto& [rule, production] : grown)
    genotype.rules[rule].production = std::move(production);
  return genotype;
}

Genotype HandedDown(const Individual& parent, const Experiment& experiment) {
  const SeasonResult* season =
      experiment.scenario.plasticity == Plasticity::kLifelong
          ? LastReached(parent)
          : &parent.evaluation.seasons.front();
  const std::vector<State>& states = parent.genotype.states;
  if (experiment.inheritance != Inheritance::kJoined || season == nullptr ||
      season->sensed.size() != states.size())
    return parent.genotype;
  return WithJoinedRules(parent.genotype,
                         EnvironmentOf(season->sensed, states));
}

}  // namespace plsc
