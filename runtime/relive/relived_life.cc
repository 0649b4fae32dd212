#include "runtime/relive/relived_life.h"

#include "runtime/develop/descriptors.h"
#include "runtime/store/schema.h"

namespace plsc {

namespace {

// The schema of runs whose measures files of relived lives have. They are the
// first that List gives: what came later stands behind.
constexpr int kMeasuresOf = 4;

}  // namespace

RelivedSeason RelivedOf(const LifeOf& of, int n, double lift,
                        const SeasonResult& result) {
  RelivedSeason relived;
  relived.of = of;
  relived.n = n;
  relived.lift = lift;
  relived.outcome = result.outcome;
  relived.reason = result.reason;
  relived.behaviour = result.behaviour;
  relived.fitness = result.fitness;
  relived.state_hash = result.state_hash;
  relived.steps = result.steps;
  relived.solver_warnings = result.solver_warnings;
  return relived;
}

const std::vector<std::string>& RelivedMeasures() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all = BehaviourColumns(kMeasuresOf);
    all.insert(all.begin(), "fitness");
    return all;
  }();
  return names;
}

std::vector<std::optional<double>> MeasuresOf(const Behaviour& behaviour,
                                              std::optional<double> fitness) {
  std::vector<std::optional<double>> values = {fitness};
  const std::vector<NamedValue> list = List(behaviour);
  for (std::size_t i = 0; values.size() < RelivedMeasures().size(); ++i)
    values.push_back(behaviour.is_valid ? std::optional(list[i].value)
                                        : std::nullopt);
  return values;
}

}  // namespace plsc
