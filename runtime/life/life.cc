// A life, season by season: sense, develop, simulate, measure. Seasons of
// independent lives are strangers to each other; in a continuous life the same
// body is carried over the change of ground if the very same robot develops
// again, and otherwise the new body is put down where the old one was, with its
// heading and the oscillators' time. What ends such a life (no robot, an
// outcome other than completed) leaves all later seasons unreached, which is
// their outcome and not a fitness of 0.
//
// LifePlanner does the same from answers, season by season; whatever is changed
// in one must be changed in the other, and tests compare them bit for bit.

#include "runtime/life/life.h"

#include <fmt/format.h>

#include <cassert>
#include <utility>

#include "runtime/life/season_developer.h"
#include "sim/imu.h"
#include "sim/passage.h"

namespace plsc {

Simulated MeasureSeason(const Trajectory& trajectory, const Scenario& scenario,
                        int size) {
  Simulated simulated;
  simulated.outcome = trajectory.outcome;
  simulated.reason = trajectory.reason;
  simulated.behaviour =
      Measure(trajectory, size, scenario.measured, scenario.targets);
  simulated.state_hash = trajectory.state_hash;
  simulated.steps = trajectory.steps;
  simulated.solver_warnings = trajectory.solver_warnings;
  return simulated;
}

Life::Life(const Genotype& genotype, const Scenario& scenario, Watcher* watcher,
           Senses inherited, Disturbances disturbances)
    : genotype_(genotype),
      scenario_(scenario),
      inherited_(std::move(inherited)),
      disturbances_(std::move(disturbances)),
      watcher_(watcher),
      seasons_(std::make_unique<SeasonDeveloper>(genotype_, scenario_,
                                                 inherited_)) {}

Life::~Life() = default;

bool Life::is_over() const {
  return seasons_->is_over();
}

bool Life::LivesOn() const {
  return scenario_.lives == Lives::kContinuous && next_ > 0;
}

Lived Life::LiveIn(const Season& season, const SimulationOptions& options,
                   const Phenotype& robot, const Spot& spot) const {
  Onset onset;
  if (LivesOn() && robot == *robot_)
    onset.carried = &state_;
  else if (LivesOn())
    onset = {state_.time, spot, nullptr};
  onset.disturbance = DisturbanceIn(disturbances_, next_);
  return Live(robot, season.terrain, options, onset, watcher_);
}

SeasonLife Life::Next() {
  assert(!is_over());
  const Season& season = seasons_->season();
  SeasonLife life;
  if (LivesOn() && !ended_.empty()) {
    life.result = seasons_->Skip();
    life.result.reason = life.trajectory.reason = ended_;
    life.trajectory.outcome = life.result.outcome;
    ++next_;
    return life;
  }
  SimulationOptions options = OptionsFor(scenario_, season);
  Spot spot;
  double begin = 0;
  if (LivesOn()) {
    options.start_height.reset();  // it stands on the ground already
    state_ = Carry(state_, *robot_,
                   {scenario_.seasons[next_ - 1].terrain, season.terrain,
                    options.start_clearance});
    begin = state_.time;
    spot = SpotOf(state_.core);
  }
  std::optional<double> inclination;
  if (seasons_->AsksImu()) {
    const Disturbance disturbance = DisturbanceIn(disturbances_, next_);
    if (!LivesOn()) spot = FeltSpot(season.terrain, disturbance);
    inclination = FeltWith(disturbance, FeltInclination(season.terrain, options,
                                                        scenario_.imu, spot));
  }
  DevelopedSeason developed = seasons_->Next(begin, inclination);
  if (!developed.robot) {
    ended_ = fmt::format("no robot developed for season '{}'", season.name);
    life.trajectory.outcome = developed.result.outcome;
    life.trajectory.reason = developed.result.reason;
    life.result = std::move(developed.result);
    ++next_;
    return life;
  }
  // Robots without joints are simulated too: their fitness is known, but not
  // how they come to rest.
  Lived lived = LiveIn(season, options, *developed.robot, spot);
  life.trajectory = std::move(lived.trajectory);
  Simulated simulated = MeasureSeason(life.trajectory, scenario_,
                                      developed.result.body.absolute_size);
  simulated.begin = begin;
  life.result = Complete(std::move(developed.result), simulated, season);
  // Who has no fitness may live on all the same.
  if (simulated.outcome != Outcome::kCompleted)
    ended_ = fmt::format("the life ended in season '{}': {}", season.name,
                         OutcomeName(simulated.outcome));
  robot_ = life.robot = std::move(developed.robot);
  state_ = std::move(lived.end);
  ++next_;
  return life;
}

}  // namespace plsc
