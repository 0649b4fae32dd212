// Counts over one development an environment, from its history: a symbol counts
// as used if it was replaced (it called its rules) or if late development
// expressed it, anywhere. Robots are compared with the first environment's by
// the places of their modules (compare/body_difference).

#include "runtime/advice/genotype_stats.h"

#include <algorithm>
#include <set>
#include <utility>

#include "runtime/compare/body_difference.h"
#include "runtime/develop/phenotype_json.h"
#include "runtime/develop/trace.h"

namespace plsc {

namespace {

// Which symbols of each rule are expressed.
using ExpressedSymbols = std::vector<std::vector<bool>>;

ExpressedSymbols NoneOf(const Genotype& genotype) {
  ExpressedSymbols none;
  for (const Rule& rule : genotype.rules)
    none.emplace_back(rule.production.size(), false);
  return none;
}

std::size_t CountSymbols(const std::vector<bool>& symbols) {
  return static_cast<std::size_t>(
      std::count(symbols.begin(), symbols.end(), true));
}

std::size_t CountSymbols(const ExpressedSymbols& rules) {
  std::size_t count = 0;
  for (const std::vector<bool>& symbols : rules) count += CountSymbols(symbols);
  return count;
}

class EnvironmentCount {
 public:
  EnvironmentCount(const Genotype& genotype, const History& history)
      : genotype_(genotype), history_(history), expressed_(NoneOf(genotype)) {
    stats_.rules.resize(genotype.rules.size());
    CountRules();
    CountString();
    if (history.trace) CountRobot(*history.trace);
    for (std::size_t i = 0; i < expressed_.size(); ++i)
      stats_.rules[i].expressed = CountSymbols(expressed_[i]);
    stats_.expressed = CountSymbols(expressed_);
  }

  const EnvironmentStats& stats() const { return stats_; }
  const ExpressedSymbols& expressed() const { return expressed_; }

 private:
  void Express(const Occurrence& occurrence) {
    if (occurrence.rule != kNoRule)
      expressed_[occurrence.rule][occurrence.position] = true;
  }

  // A replaced symbol counts as expressed: it called its rules.
  void CountRules() {
    std::vector<std::uint64_t> replaced(genotype_.alphabet->symbols().size());
    for (const Insertion& insertion : history_.derivation.insertions) {
      if (insertion.child_count == 0) continue;
      ++replaced[static_cast<std::size_t>(insertion.occurrence.symbol)];
      Express(insertion.occurrence);
    }
    for (const RuleIndex rule : history_.active.rules) {
      const auto head = static_cast<std::size_t>(genotype_.rules[rule].head);
      stats_.rules[rule].is_active = true;
      stats_.rules[rule].applied = replaced[head];
    }
  }

  void CountString() {
    const std::vector<InsertionId>& string = history_.derivation.string();
    stats_.length = string.size();
    for (std::size_t i = 0; i < string.size(); ++i) {
      const bool is_expressed =
          !history_.trace ||
          InfoOf(history_.trace->events[i].effect).is_expressed;
      if (!is_expressed) continue;
      ++stats_.string_expressed;
      Express(history_.derivation[string[i]].occurrence);
    }
  }

  void CountRobot(const Trace& trace) {
    stats_.has_body = true;
    for (std::size_t i = 0; i < trace.phenotype.body.modules.size(); ++i) {
      const Module& module = trace.phenotype.body.modules[i];
      const bool is_sensor = module.type == ModuleType::kTouchSensor;
      ++(is_sensor ? stats_.sensors : stats_.modules);
      if (IsJoint(module.type)) ++stats_.joints;
      const InsertionId origin =
          history_.derivation.string()[trace.module_origins[i]];
      const RuleIndex rule = history_.derivation[origin].occurrence.rule;
      if (rule != kNoRule) ++stats_.rules[rule].modules;
    }
    stats_.nodes = trace.phenotype.brain.nodes.size();
    stats_.edges = trace.phenotype.brain.connections.size();
  }

  const Genotype& genotype_;
  const History& history_;
  EnvironmentStats stats_;
  ExpressedSymbols expressed_;
};

RobotDifference Compare(const Phenotype& reference, const Phenotype& robot) {
  const BodyDifference bodies = CompareBodies(reference.body, robot.body);
  const auto count = [&](ModuleMark mark) {
    return static_cast<std::size_t>(
        std::count(bodies.marks.begin(), bodies.marks.end(), mark));
  };
  return {count(ModuleMark::kShared), count(ModuleMark::kOther),
          count(ModuleMark::kNew), bodies.missing.size(),
          BrainJson(reference) != BrainJson(robot)};
}

void Unite(const ExpressedSymbols& more, ExpressedSymbols* all) {
  for (std::size_t r = 0; r < more.size(); ++r)
    for (std::size_t s = 0; s < more[r].size(); ++s)
      if (more[r][s]) (*all)[r][s] = true;
}

GenotypeStats CountWritten(const Genotype& genotype) {
  GenotypeStats stats;
  stats.name = genotype.name;
  stats.rules = genotype.rules.size();
  for (const Rule& rule : genotype.rules) {
    stats.terms += rule.clause.terms.size();
    stats.symbols += rule.production.size();
  }
  return stats;
}

}  // namespace

Expected<GenotypeStats, OutgrownIn> StatsOf(
    const Genotype& genotype,
    const std::vector<NamedEnvironment>& environments) {
  GenotypeStats stats = CountWritten(genotype);
  ExpressedSymbols expressed = NoneOf(genotype);
  std::vector<bool> is_active(genotype.rules.size(), false);
  std::set<std::string> bodies;
  std::set<std::string> brains;
  std::optional<Phenotype> first;
  for (std::size_t i = 0; i < environments.size(); ++i) {
    const auto history =
        DevelopWithHistory(genotype, environments[i].environment);
    if (!history) return OutgrownIn{i};
    const EnvironmentCount count(genotype, *history);
    EnvironmentStats one = count.stats();
    one.name = environments[i].name;
    Unite(count.expressed(), &expressed);
    for (const RuleIndex rule : history->active.rules) is_active[rule] = true;
    if (history->trace) {
      const Phenotype& robot = history->trace->phenotype;
      if (!first) first = robot;
      one.difference = Compare(*first, robot);
      bodies.insert(BodyJson(robot.body));
      brains.insert(BrainJson(robot));
    }
    stats.environments.push_back(std::move(one));
  }
  stats.expressed = CountSymbols(expressed);
  stats.active = CountSymbols(is_active);
  stats.bodies = bodies.size();
  stats.brains = brains.size();
  return stats;
}

}  // namespace plsc
