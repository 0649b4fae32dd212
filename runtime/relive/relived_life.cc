#include "runtime/relive/relived_life.h"

#include "runtime/develop/descriptors.h"

namespace plsc {

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
    std::vector<std::string> all = {"fitness"};
    for (const NamedValue& value : List(Behaviour{}))
      all.emplace_back(value.name);
    return all;
  }();
  return names;
}

std::vector<std::optional<double>> MeasuresOf(const Behaviour& behaviour,
                                              std::optional<double> fitness) {
  std::vector<std::optional<double>> values = {fitness};
  for (const NamedValue& value : List(behaviour))
    values.push_back(behaviour.is_valid ? std::optional(value.value)
                                        : std::nullopt);
  return values;
}

}  // namespace plsc
