#include "runtime/report/robots.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "compiler/print.h"
#include "runtime/develop/develop.h"
#include "runtime/develop/phenotype_json.h"
#include "runtime/life/season_developer.h"
#include "runtime/pictures/body_svg.h"

namespace plsc {

namespace {

/// What regulates a robot in each of its seasons; nothing where its life did
/// not get to.
std::vector<std::optional<Environment>> EnvironmentsOf(const Individual& one,
                                                       Plasticity plasticity) {
  const std::vector<State>& states = one.genotype.states;
  std::vector<std::optional<Environment>> environments;
  for (const SeasonResult& season : one.evaluation.seasons) {
    const bool is_born_only =
        plasticity == Plasticity::kMorphogenesis && !environments.empty();
    if (is_born_only)
      environments.push_back(environments.front());
    else if (season.sensed.size() == states.size())
      environments.emplace_back(EnvironmentOf(season.sensed, states));
    else
      environments.emplace_back(std::nullopt);
  }
  return environments;
}

std::vector<RuleUse> RulesOf(
    const Genotype& genotype,
    const std::vector<std::optional<Environment>>& environments) {
  std::vector<RuleUse> uses;
  for (const Rule& rule : genotype.rules) {
    RuleUse use;
    use.symbol = genotype.SymbolOf(rule.head).name;
    if (!rule.clause.is_always())
      use.clause = PrintClause(rule.clause, genotype);
    uses.push_back(std::move(use));
  }
  for (const std::optional<Environment>& environment : environments) {
    for (RuleUse& use : uses) use.is_held.push_back(false);
    if (!environment) continue;
    for (const RuleIndex rule : Regulate(genotype, *environment).rules)
      uses[rule].is_held.back() = true;
  }
  return uses;
}

SeasonPortrait PortraitIn(const SeasonResult& season) {
  SeasonPortrait portrait;
  portrait.season = season.season;
  portrait.outcome = season.outcome;
  if (season.behaviour.is_valid) {
    portrait.speed = season.behaviour.displacement_velocity_hill;
    portrait.balance = season.behaviour.head_balance;
  }
  portrait.size = season.body.absolute_size;
  portrait.change = season.change;
  portrait.sensed = season.sensed;
  return portrait;
}

/// Empty if the stored body is not what develops.
std::string DrawBody(const Genotype& genotype, const Environment& environment,
                     const std::string& stored) {
  const std::optional<Phenotype> robot = Develop(genotype, environment);
  if (!robot || BodyJson(robot->body) != stored) return "";
  return BodySvg(robot->body, "");
}

}  // namespace

Expected<Portrait, Failure> PortraitOf(RunStore& store, int id) {
  const Expected<Individual, Failure> one = store.Find(id);
  if (!one) return one.error();
  const Expected<std::vector<SeasonEvidence>, Failure> evidence =
      store.EvidenceOf(id);
  if (!evidence) return evidence.error();
  const auto environments =
      EnvironmentsOf(*one, store.experiment().scenario.plasticity);
  Portrait portrait;
  portrait.id = id;
  portrait.name = one->genotype.name;
  portrait.born = one->generation;
  portrait.states = one->genotype.states;
  for (std::size_t i = 0; i < one->evaluation.seasons.size(); ++i) {
    SeasonPortrait season = PortraitIn(one->evaluation.seasons[i]);
    if (i < evidence->size() && environments[i])
      season.svg =
          DrawBody(one->genotype, *environments[i], (*evidence)[i].body);
    portrait.seasons.push_back(std::move(season));
  }
  portrait.rules = RulesOf(one->genotype, environments);
  return portrait;
}

Expected<std::vector<RuleCount>, Failure> CountRules(
    RunStore& store, const std::vector<int>& ids) {
  std::vector<RuleCount> all;
  for (const int id : ids) {
    const Expected<Individual, Failure> one = store.Find(id);
    if (!one) return one.error();
    std::vector<RuleCount> counts;
    for (RuleUse& use :
         RulesOf(one->genotype,
                 EnvironmentsOf(*one, store.experiment().scenario.plasticity)))
      counts.push_back({std::move(use), 1});
    AddRules(counts, all);
  }
  return all;
}

void AddRules(const std::vector<RuleCount>& more, std::vector<RuleCount>& all) {
  const auto key = [](const RuleCount& one) {
    return std::tie(one.rule.symbol, one.rule.clause, one.rule.is_held);
  };
  for (const RuleCount& one : more) {
    const auto place =
        std::lower_bound(all.begin(), all.end(), one,
                         [&](const RuleCount& a, const RuleCount& b) {
                           return key(a) < key(b);
                         });
    if (place != all.end() && key(*place) == key(one))
      place->count += one.count;
    else
      all.insert(place, one);
  }
}

}  // namespace plsc
