// A season is two halves: what follows from genotype and scenario by thinking
// (what is sensed, which rules are active, what develops, how that differs from
// the season before), and what only the simulator knows. This is the first
// half, and the only place of it: a life that is lived (Life) and one that is
// planned and put together from answers (LifePlanner) both go through here, so
// they cannot differ in it.
//
// One number comes from physics, the inclination that an IMU would read, and
// only if AsksImu. It must be given then and only then; tests compare
// both ways bit for bit.
//
// Seasons are developed in order and each exactly once (Next or Skip): with
// plasticity "morphogenesis" the robot of birth and what it sensed then are
// kept, and the change of a season is one against the last robot that there
// was. A season costs one development.

#include "runtime/life/season_developer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "compiler/environment_text.h"
#include "runtime/develop/develop.h"
#include "runtime/life/season_quantities.h"

namespace plsc {

namespace {

/// "inclined=True (IMU 5.0 deg)", "inclined False -> True".
std::string DescribeState(const SensedState& state,
                          const std::optional<double>& inclination,
                          std::string_view before) {
  const std::string value = before.empty()
                                ? "=" + state.value
                                : fmt::format(" {} -> {}", before, state.value);
  if (state.from == SenseSource::kParent)
    return fmt::format("{}{} (parent)", state.name, value);
  if (state.from != SenseSource::kImu) return state.name + value;
  return fmt::format("{}{} (IMU {:.1f} deg)", state.name, value,
                     *inclination * 180 / std::numbers::pi);
}

}  // namespace

bool SeasonDeveloper::IsGrown() const {
  return scenario_.plasticity == Plasticity::kMorphogenesis && robot_;
}

bool SeasonDeveloper::AsksImu() const {
  if (IsInherited() || IsGrown()) return false;
  return std::any_of(
      genotype_.states.begin(), genotype_.states.end(),
      [&](const State& state) { return IsFelt(scenario_, season(), state); });
}

std::vector<SensedState> SeasonDeveloper::SenseNow(
    std::optional<double> inclination) const {
  if (IsGrown()) return sensed_;
  std::vector<SensedState> sensed;
  for (const State& state : genotype_.states) {
    if (IsInherited()) {
      const auto own = inherited_.find(state.name);
      assert(own != inherited_.end());
      sensed.push_back({state.name, own->second, SenseSource::kParent});
    } else if (IsFelt(scenario_, season(), state)) {
      const bool is_inclined = *inclination > scenario_.imu.threshold;
      sensed.push_back(
          {state.name, is_inclined ? "True" : "False", SenseSource::kImu});
    } else {
      const auto given = season().senses.find(state.name);
      assert(given != season().senses.end());
      sensed.push_back({state.name, given->second, SenseSource::kSeason});
    }
  }
  return sensed;
}

SeasonResult SeasonDeveloper::Begin() const {
  SeasonResult result;
  result.season = season().name;
  result.profile = scenario_.profile;
  return result;
}

void SeasonDeveloper::DescribeChange(const Phenotype& robot,
                                     SeasonResult& result) const {
  result.change = !robot_                        ? Change::kBorn
                  : robot.body != robot_->body   ? Change::kBody
                  : robot.brain != robot_->brain ? Change::kBrain
                                                 : Change::kNone;
  if (IsGrown()) {
    result.change_reason = "developed at birth";
    return;
  }
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < result.sensed.size(); ++i) {
    const SensedState& now = result.sensed[i];
    if (!robot_)
      parts.push_back(DescribeState(now, result.inclination, ""));
    else if (now.value != sensed_[i].value)
      parts.push_back(DescribeState(now, result.inclination, sensed_[i].value));
  }
  result.change_reason = parts.empty()
                             ? (robot_ ? "senses as before" : "senses nothing")
                             : fmt::format("{}", fmt::join(parts, ", "));
}

DevelopedSeason SeasonDeveloper::Next(double begin,
                                      std::optional<double> inclination) {
  assert(!is_over() && inclination.has_value() == AsksImu());
  DevelopedSeason developed;
  SeasonResult& result = developed.result = Begin();
  result.begin = begin;
  result.inclination = inclination;
  result.sensed = SenseNow(inclination);
  developed.robot =
      IsGrown()
          ? robot_
          : Develop(genotype_, EnvironmentOf(result.sensed, genotype_.states));
  if (developed.robot) {
    DescribeChange(*developed.robot, result);
    result.body = DescribeBody(developed.robot->body);
    result.brain = DescribeBrain(*developed.robot);
    robot_ = developed.robot;
    sensed_ = result.sensed;
  } else {
    result.outcome = Outcome::kUndeveloped;
    result.reason = "the string would grow beyond 2^20 symbols";
  }
  ++next_;
  return developed;
}

SeasonResult SeasonDeveloper::Skip() {
  SeasonResult result = Begin();
  result.outcome = Outcome::kNotReached;
  ++next_;
  return result;
}

Environment EnvironmentOf(const std::vector<SensedState>& sensed,
                          const std::vector<State>& states) {
  assert(sensed.size() == states.size());
  Environment environment;
  for (std::size_t i = 0; i < sensed.size(); ++i) {
    const auto value = ParseStateValue(sensed[i].value, states[i]);
    assert(value);
    environment.values.push_back(*value);
  }
  return environment;
}

SeasonResult Complete(SeasonResult developed, const Simulated& simulated,
                      const Season& season) {
  SeasonResult result = std::move(developed);
  result.begin = simulated.begin;
  result.outcome = simulated.outcome;
  result.reason = simulated.reason;
  result.behaviour = simulated.behaviour;
  result.state_hash = simulated.state_hash;
  result.steps = simulated.steps;
  result.solver_warnings = simulated.solver_warnings;
  // No fitness is worse than any: what broke off is not paid for the part that
  // it walked.
  if (result.outcome != Outcome::kCompleted) return result;
  const double speed = result.behaviour.displacement_velocity_hill;
  assert(std::isfinite(speed));
  if (!season.fitness) {
    result.fitness = SeasonFitness(speed, result.body.hinge_count);
    return result;
  }
  const FormulaValue value =
      season.fitness->Evaluate(QuantitiesOf(result, season));
  if (value.problem == nullptr) {
    result.fitness = value.value;
  } else {
    result.outcome = Outcome::kUndefinedFitness;
    result.reason = DescribeProblem(*season.fitness, value);
  }
  return result;
}

Simulated SimulatedOf(const SeasonResult& result) {
  Simulated simulated = {result.begin,     result.inclination,
                         result.outcome,   result.reason,
                         result.behaviour, result.state_hash,
                         result.steps,     result.solver_warnings};
  // What it is worth was not simulated.
  if (result.outcome == Outcome::kUndefinedFitness) {
    simulated.outcome = Outcome::kCompleted;
    simulated.reason.clear();
  }
  return simulated;
}

}  // namespace plsc
