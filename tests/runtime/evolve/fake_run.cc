#include "tests/runtime/evolve/fake_run.h"

#include "runtime/develop/phenotype_json.h"

namespace plsc::test {

Experiment SmallExperiment() {
  Experiment experiment;
  experiment.population = 8;
  experiment.offspring = 6;
  experiment.generations = 5;
  return experiment;
}

std::uint64_t NumberOf(const Phenotype& robot) {
  return KeyOf(BodyJson(robot.body) + BrainJson(robot)).low;
}

Simulated Look(const Phenotype& robot, const Season& season,
               const Disturbance& disturbance) {
  Simulated seen;
  seen.steps = 10000;
  seen.state_hash = NumberOf(robot) + season.name.size();
  if (disturbance != Disturbance{})
    seen.state_hash ^= KeyOf(DisturbanceText(disturbance)).low;
  const bool is_flat = season.name == "flat";
  if (!is_flat && NumberOf(robot) % 11 == 0) {
    seen.outcome = Outcome::kUnstable;
    seen.reason = "a joint was torn";
    return seen;
  }
  double liked = 0;
  for (const Module& module : robot.body.modules)
    liked += is_flat ? IsJoint(module.type)
                     : module.type == ModuleType::kTouchSensor;
  seen.behaviour.is_valid = true;
  seen.behaviour.displacement_velocity_hill =
      0.01 + liked / 3 + 1e-3 * static_cast<double>(NumberOf(robot) % 7) +
      disturbance.lift / 10;
  return seen;
}

MaybeFailure Recorder::OnBirths(const std::vector<Individual>& born,
                                const std::function<bool()>& /*should_stop*/) {
  std::vector<int> ids;
  for (const Individual& one : born) ids.push_back(one.id);
  births.push_back(ids);
  individuals.resize(static_cast<std::size_t>(ids.back()));
  evidence.resize(individuals.size());
  return std::nullopt;
}

MaybeFailure Recorder::OnEvaluated(const Individual& one,
                                   const std::vector<SeasonEvidence>& its) {
  if (failing_after > 0 && evaluated.size() == failing_after)
    return "the disk is full";
  const auto place = static_cast<std::size_t>(one.id - 1);
  individuals[place] = one;
  evidence[place] = its;
  evaluated.push_back(one.id);
  return std::nullopt;
}

MaybeFailure Recorder::OnGeneration(const GenerationRecord& record) {
  generations.push_back(record);
  return std::nullopt;
}

}  // namespace plsc::test
