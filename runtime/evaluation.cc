#include "runtime/evaluation.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <numbers>

#include "runtime/develop.h"
#include "sim/imu.h"
#include "sim/passage.h"

namespace plsc {

namespace {

// What a robot that cannot move, or does not, is worth, m/s: less than the
// fastest slide down a slope (in m/s, as the authors compute it,
// although the paper's Speed is in cm/s).
constexpr double kMotionless = -0.1;
// Sliding back counts a tenth, so that small losses do not end a lineage.
constexpr double kBackwardShare = 0.1;

SimulationOptions OptionsFor(const Scenario& scenario, const Season& season) {
  SimulationOptions options;
  options.duration = season.duration;
  options.sample_interval = scenario.sample_interval;
  options.start_height = season.start_height;
  options.start_clearance = scenario.start_clearance;
  options.controller = scenario.controller;
  options.max_steps = scenario.max_steps;
  options.max_links = scenario.max_links;
  options.physics = season.physics;
  options.servo = scenario.servo;
  return options;
}

/// "inclined=True (IMU 5.0 deg)".
std::string TellState(const SensedState& state, const SeasonResult& result,
                      std::string_view before) {
  const std::string value = before.empty()
                                ? "=" + state.value
                                : fmt::format(" {} -> {}", before, state.value);
  if (!state.is_felt) return state.name + value;
  return fmt::format("{}{} (IMU {:.1f} deg)", state.name, value,
                     *result.inclination * 180 / std::numbers::pi);
}

void Judge(const Trajectory& trajectory, MeasuredPoint point,
           SeasonResult& result) {
  result.outcome = trajectory.outcome;
  result.reason = trajectory.reason;
  result.state_hash = trajectory.state_hash;
  result.steps = trajectory.steps;
  result.solver_warnings = trajectory.solver_warnings;
  result.behaviour = Measure(trajectory, result.body.absolute_size, point);
  if (result.outcome != Outcome::kCompleted) return;
  const double speed = result.behaviour.displacement_velocity_hill;
  assert(std::isfinite(speed));
  result.fitness = SeasonFitness(speed, result.body.hinge_count);
}

}  // namespace

std::string_view ChangeName(Change change) {
  switch (change) {
    case Change::kBorn:
      return "born";
    case Change::kNone:
      return "none";
    case Change::kBrain:
      return "brain";
    case Change::kBody:
      return "body";
  }
  assert(false);
  return "";
}

double SeasonFitness(double speed, int hinge_count) {
  if (hinge_count == 0 || speed == 0) return kMotionless;
  return speed > 0 ? speed : speed * kBackwardShare;
}

bool Life::LivesOn() const {
  return scenario_.lives == Lives::kContinuous && next_ > 0;
}

Environment Life::SenseAt(const Season& season,
                          const SimulationOptions& options, const Spot& spot,
                          SeasonResult& result) const {
  std::map<std::string, std::string> felt;
  for (const State& state : genotype_.states) {
    if (!IsFelt(scenario_, season, state)) continue;
    result.inclination =
        FeltInclination(season.terrain, options, scenario_.imu, spot);
    const bool is_inclined = *result.inclination > scenario_.imu.threshold;
    felt[state.name] = is_inclined ? "True" : "False";
  }
  for (const State& state : genotype_.states) {
    const auto own = felt.find(state.name);
    const bool is_felt = own != felt.end();
    const auto given = season.senses.find(state.name);
    assert(is_felt || given != season.senses.end());
    result.sensed.push_back(
        {state.name, is_felt ? own->second : given->second, is_felt});
  }
  const Result<Environment> sensed = Sense(season, genotype_.states, felt);
  assert(sensed);
  return *sensed;
}

void Life::TellChange(const Phenotype& robot, SeasonResult& result) const {
  result.change = !robot_                        ? Change::kBorn
                  : robot.body != robot_->body   ? Change::kBody
                  : robot.brain != robot_->brain ? Change::kBrain
                                                 : Change::kNone;
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < result.sensed.size(); ++i) {
    const SensedState& now = result.sensed[i];
    if (!robot_)
      parts.push_back(TellState(now, result, ""));
    else if (now.value != sensed_[i].value)
      parts.push_back(TellState(now, result, sensed_[i].value));
  }
  result.change_reason = parts.empty()
                             ? (robot_ ? "senses as before" : "senses nothing")
                             : fmt::format("{}", fmt::join(parts, ", "));
}

Lived Life::LiveIn(const Season& season, const SimulationOptions& options,
                   const Phenotype& robot, const Spot& spot) const {
  Onset onset;
  if (LivesOn() && robot == *robot_)
    onset.carried = &state_;
  else if (LivesOn())
    onset = {state_.time, spot, nullptr};
  return Live(robot, season.terrain, options, onset, watcher_);
}

SeasonLife Life::Next() {
  assert(!is_over());
  const Season& season = scenario_.seasons[next_];
  SeasonLife life;
  SeasonResult& result = life.result;
  result.season = season.name;
  result.profile = scenario_.profile;
  const auto end = [&](Outcome outcome, std::string reason) {
    result.outcome = life.trajectory.outcome = outcome;
    result.reason = life.trajectory.reason = std::move(reason);
    ++next_;
    return std::move(life);
  };
  if (LivesOn() && !ended_.empty()) return end(Outcome::kNotReached, ended_);

  SimulationOptions options = OptionsFor(scenario_, season);
  Spot spot;
  if (LivesOn()) {
    options.start_height.reset();  // it stands on the ground already
    state_ = Carry(state_, *robot_,
                   {scenario_.seasons[next_ - 1].terrain, season.terrain,
                    options.start_clearance});
    result.begin = state_.time;
    spot = SpotOf(state_.core);
  }
  const Environment environment = SenseAt(season, options, spot, result);
  const std::optional<Phenotype> robot = Develop(genotype_, environment);
  if (!robot) {
    ended_ = fmt::format("no robot developed for season '{}'", season.name);
    return end(Outcome::kUndeveloped,
               "the string would grow beyond 2^20 symbols");
  }
  TellChange(*robot, result);
  result.body = DescribeBody(robot->body);
  result.brain = DescribeBrain(*robot);
  // Robots without joints are simulated too: their fitness is known, but not
  // how they come to rest.
  Lived lived = LiveIn(season, options, *robot, spot);
  life.trajectory = std::move(lived.trajectory);
  Judge(life.trajectory, scenario_.measured, result);
  if (result.outcome != Outcome::kCompleted)
    ended_ = fmt::format("the life ended in season '{}': {}", season.name,
                         OutcomeName(result.outcome));
  robot_ = life.robot = *robot;
  sensed_ = result.sensed;
  state_ = std::move(lived.end);
  ++next_;
  return life;
}

Evaluation Evaluate(const Genotype& genotype, const Scenario& scenario) {
  Evaluation evaluation;
  for (Life life(genotype, scenario); !life.is_over();)
    evaluation.seasons.push_back(life.Next().result);
  return evaluation;
}

}  // namespace plsc
