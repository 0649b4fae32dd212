#include "runtime/evaluation.h"

#include <cassert>
#include <cmath>

#include "runtime/develop.h"
#include "sim/simulate.h"

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
  options.controller = scenario.controller;
  options.physics = scenario.physics;
  options.servo = scenario.servo;
  return options;
}

}  // namespace

double SeasonFitness(double speed, int hinge_count) {
  if (hinge_count == 0 || speed == 0) return kMotionless;
  return speed > 0 ? speed : speed * kBackwardShare;
}

SeasonLife LiveSeason(const Genotype& genotype, const Scenario& scenario,
                      const Season& season) {
  SeasonLife life;
  SeasonResult& result = life.result;
  result.season = season.name;
  const Result<Environment> sensed = Sense(season, genotype.states);
  assert(sensed);
  const std::optional<Phenotype> robot = Develop(genotype, *sensed);
  if (!robot) {
    result.outcome = Outcome::kUndeveloped;
    life.trajectory.outcome = result.outcome;
    return life;
  }
  result.body = DescribeBody(robot->body);
  result.brain = DescribeBrain(*robot);
  // Robots without joints are simulated too: their fitness is known, but not
  // how they come to rest.
  life.trajectory =
      Simulate(*robot, season.terrain, OptionsFor(scenario, season));
  result.outcome = life.trajectory.outcome;
  result.state_hash = life.trajectory.state_hash;
  result.behaviour = Measure(life.trajectory, result.body.absolute_size);
  if (result.outcome == Outcome::kCompleted) {
    const double speed = result.behaviour.displacement_velocity_hill;
    assert(std::isfinite(speed));
    result.fitness = SeasonFitness(speed, result.body.hinge_count);
  }
  return life;
}

Evaluation Evaluate(const Genotype& genotype, const Scenario& scenario) {
  Evaluation evaluation;
  for (const Season& season : scenario.seasons)
    evaluation.seasons.push_back(LiveSeason(genotype, scenario, season).result);
  return evaluation;
}

}  // namespace plsc
