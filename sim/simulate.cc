// One season: what forbids it is said first, then three clocks run side by side
// in whole steps (sim/schedule): physics at every step, the controller when its
// update is due, samples for measures. The controller acts before the step, on
// the touches and angles that the last one left, so an update sees one state
// and not half of the next.
//
// A life that is carried on begins in a new world with the old one's poses and
// speeds, and with the controller's memory and time; that is all the state
// there is but for the solver's order, which begins anew in each season.
// Whoever watches sees the world between two steps and cannot change it: a
// watched life is the same bit for bit.

#include "sim/simulate.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "sim/assembly.h"
#include "sim/controller.h"
#include "sim/overlap.h"
#include "sim/recorder.h"
#include "sim/schedule.h"
#include "sim/servo_errors.h"

namespace plsc {
namespace {

/// A controller at its own pace, and the servos it drives; with the errors of
/// its sensors and of its servos, if any.
class Drive {
 public:
  Drive(const Phenotype& phenotype, const SimulationOptions& options,
        const Disturbance& disturbance, double birth)
      : controller_(phenotype, options.controller),
        schedule_(options.servo, options.physics.step),
        servo_(options.servo),
        touch_(disturbance.touch),
        motor_(disturbance.motor),
        birth_(birth) {
    const std::vector<Module>& modules = phenotype.body.modules;
    for (std::size_t i = 0; i < modules.size(); ++i)
      if (modules[i].type == ModuleType::kTouchSensor)
        sensors_.push_back(static_cast<int>(i));
      else if (IsJoint(modules[i].type))
        asked_.push_back(0);
    speeds_ = before_ = torques_ = asked_;
  }

  /// Before each step: sets the joints' speeds if an update is due.
  void Act(std::int64_t step, World& world) {
    if (world.joints() == 0) return;
    const std::optional<double> due = schedule_.Due(step);
    if (!due) return;
    const auto& outputs = controller_.Update(birth_ + *due, Felt(world));
    for (int joint = 0; joint < world.joints(); ++joint) {
      const auto i = static_cast<std::size_t>(joint);
      asked_[i] = ServoSpeed(Erring(outputs[i], joint), world.JointAngle(joint),
                             servo_);
      world.SetJointSpeed(joint, asked_[i]);
    }
    ++updates_;
  }

  /// After each step: how far the joints are from what was asked of them, and
  /// what it took to turn them.
  void Look(const World& world) {
    std::swap(speeds_, before_);
    world.TellJointSpeeds(speeds_);
    world.TellJointTorques(torques_);
    for (std::size_t i = 0; i < speeds_.size(); ++i) {
      errors_.Add(speeds_[i] - asked_[i]);
      // A torque that is constant in a step works at the mean of both speeds.
      power_ += std::abs(torques_[i] * (before_[i] + speeds_[i])) / 2;
    }
  }

  Controller& controller() { return controller_; }
  const ServoErrors& errors() const { return errors_; }
  double power() const { return power_; }  ///< W, summed over all steps

 private:
  /// What the sensors tell, by Body::modules.
  const std::vector<bool>& Felt(const World& world) {
    if (touch_.amplitude == 0) return world.touched();
    felt_ = world.touched();
    for (const int sensor : sensors_)
      if (IsFlipped(touch_, updates_, sensor))
        felt_[static_cast<std::size_t>(sensor)].flip();
    return felt_;
  }

  /// The output whose target is off by the servo's error.
  double Erring(double output, int joint) const {
    if (motor_.amplitude == 0) return output;
    return output + TargetError(motor_, updates_, joint) / (2 * servo_.range);
  }

  std::vector<double> asked_;    ///< rad/s, by joint; braked until the first
  std::vector<double> speeds_;   ///< likewise, after the latest step
  std::vector<double> before_;   ///< likewise, before it
  std::vector<double> torques_;  ///< N m, in it
  double power_ = 0;
  ServoErrors errors_;
  Controller controller_;
  RefreshSchedule schedule_;
  ServoOptions servo_;
  Noise touch_, motor_;
  std::vector<int> sensors_;  ///< indices into Body::modules
  std::vector<bool> felt_;    ///< kept: a step asks for no memory
  std::int64_t updates_ = 0;  ///< since the season's start
  double birth_;              ///< s, of the season's start since birth
};

/// Why a life cannot even begin, if so.
World::Failure Forbid(const Assembly& assembly,
                      const SimulationOptions& options) {
  const auto links = static_cast<int>(assembly.links.size());
  if (links > options.max_links)
    return {Outcome::kTooLarge, fmt::format("{} links, more than max_links, {}",
                                            links, options.max_links)};
  const double step = options.physics.step;
  const double steps = options.duration / step;  // may be beyond an integer
  if (!(steps <= static_cast<double>(options.max_steps)))
    return {Outcome::kOutOfSteps,
            fmt::format("{} s are {:.0f} steps of {} s, more than max_steps, "
                        "{}",
                        options.duration, steps, step, options.max_steps)};
  if (StepsOf(options) < 1)
    return {Outcome::kOutOfSteps,
            fmt::format("{} s are no step of {} s", options.duration, step)};
  const auto overlaps = FindOverlaps(assembly);
  if (!overlaps.empty()) {
    const auto module = [&](int link, int box) {
      return assembly.links[static_cast<std::size_t>(link)]
          .boxes[static_cast<std::size_t>(box)]
          .module;
    };
    const Overlap& first = overlaps.front();
    return {Outcome::kOverlapping,
            fmt::format("{} pairs of parts intersect in the rest pose, first "
                        "of modules {} and {}, counted from 0",
                        overlaps.size(), module(first.link_a, first.box_a),
                        module(first.link_b, first.box_b))};
  }
  return {};
}

Trajectory Nothing(const SimulationOptions& options, World::Failure failure) {
  Trajectory nothing;
  nothing.outcome = failure.outcome;
  nothing.reason = std::move(failure.reason);
  nothing.interval = options.sample_interval;
  return nothing;
}

Trajectory StoppedAt(double time, Trajectory trajectory) {
  trajectory.outcome = Outcome::kStopped;
  trajectory.reason = fmt::format("by the user after {:.1f} s", time);
  return trajectory;
}

Placement PutDown(const Assembly& assembly, const Terrain& terrain,
                  const SimulationOptions& options, const Onset& onset) {
  const Disturbance& disturbance = onset.disturbance;
  Placement start =
      StartOf(assembly, terrain, options, Displaced(onset.spot, disturbance));
  start.position.z() += disturbance.lift;
  return start;
}

std::unique_ptr<World> Enter(const Assembly& assembly, const Terrain& terrain,
                             const SimulationOptions& options,
                             const Onset& onset) {
  if (onset.carried == nullptr)
    return std::make_unique<World>(assembly, terrain, options,
                                   PutDown(assembly, terrain, options, onset));
  auto world = std::make_unique<World>(assembly, terrain, options, Placement{});
  const LifeState& state = *onset.carried;
  assert(state.poses.size() == assembly.links.size());
  for (int link = 0; link < world->links(); ++link) {
    const auto i = static_cast<std::size_t>(link);
    world->SetState(link, state.poses[i], state.motions[i]);
  }
  return world;
}

LifeState StateOf(const World& world, double time,
                  const Controller& controller) {
  LifeState state;
  state.time = time;
  state.core = {world.CorePosition(), world.PoseOf(0).axes};
  for (int link = 0; link < world.links(); ++link) {
    state.poses.push_back(world.PoseOf(link));
    state.motions.push_back(world.MotionOf(link));
  }
  state.memory = controller.memory();
  return state;
}

}  // namespace

Lived Live(const Phenotype& phenotype, const Terrain& terrain,
           const SimulationOptions& undisturbed, const Onset& onset,
           Watcher* watcher) {
  SimulationOptions options = undisturbed;
  options.physics.friction *= onset.disturbance.friction;
  assert(options.physics.step > 0 && options.sample_interval > 0 &&
         options.servo.update_rate > 0);
  const Assembly assembly = Assemble(phenotype.body);
  World::Failure forbidden = Forbid(assembly, options);
  if (forbidden.outcome != Outcome::kCompleted)
    return {Nothing(options, std::move(forbidden)), {}};
  const std::unique_ptr<World> world = Enter(assembly, terrain, options, onset);
  const double birth = onset.carried ? onset.carried->time : onset.time;
  Drive drive(phenotype, options, onset.disturbance, birth);
  if (onset.carried) drive.controller().Remember(onset.carried->memory);
  const auto samples = SampleSteps(options);
  Recorder recorder(*world, static_cast<Eigen::Index>(samples.size()),
                    options.sample_interval);
  const auto time = [&](std::int64_t step) {
    return birth + static_cast<double>(step) * options.physics.step;
  };
  const auto is_stopped = [&](std::int64_t step) {
    return watcher != nullptr && !watcher->See(*world, step);
  };
  if (watcher != nullptr) watcher->Begin(phenotype, options, birth);
  std::int64_t step = 0;
  if (is_stopped(0)) return {StoppedAt(0, recorder.Finish(*world, 0)), {}};
  for (const std::int64_t due : samples) {
    for (; step < due; ++step) {
      drive.Act(step, *world);
      if (!world->Step()) return {recorder.Finish(*world, step + 1), {}};
      drive.Look(*world);
      if (is_stopped(step + 1))
        return {StoppedAt(time(step + 1) - birth,
                          recorder.Finish(*world, step + 1)),
                {}};
    }
    recorder.Sample(*world, time(step));
  }
  Trajectory trajectory = recorder.Finish(*world, step);
  trajectory.servo_error_median = drive.errors().Median();
  trajectory.servo_error_worst = drive.errors().worst();
  trajectory.energy = drive.power() * options.physics.step;
  trajectory.weight = world->Mass() * options.physics.gravity;
  return {std::move(trajectory),
          StateOf(*world, time(step), drive.controller())};
}

Trajectory Simulate(const Phenotype& phenotype, const Terrain& terrain,
                    const SimulationOptions& options) {
  return Live(phenotype, terrain, options, {}).trajectory;
}

}  // namespace plsc
