#include "sim/simulate.h"

#include <cassert>
#include <cstddef>

#include "sim/assembly.h"
#include "sim/controller.h"
#include "sim/overlap.h"
#include "sim/recorder.h"
#include "sim/schedule.h"
#include "sim/world.h"

namespace plsc {
namespace {

/// A controller at its own pace, and the servos it drives.
class Drive {
 public:
  Drive(const Phenotype& phenotype, const SimulationOptions& options)
      : controller_(phenotype, options.controller),
        servo_(options.servo),
        step_(options.physics.step) {}

  /// Before each step: sets the joints' speeds if an update is due. Updates
  /// are at whole multiples of the period, the first at birth; the authors'
  /// program is up to a step late each time.
  void Act(std::int64_t step, World& world) {
    if (world.joints() == 0) return;
    if (step < NearestStep(DueTime(), step_)) return;
    const double time = DueTime();
    // More than once only if the pace is quicker than the steps.
    do {
      ++updates_;
    } while (NearestStep(DueTime(), step_) <= step);
    const auto outputs = controller_.Update(time, world.touched());
    for (int joint = 0; joint < world.joints(); ++joint)
      world.SetJointSpeed(joint,
                          ServoSpeed(outputs[static_cast<std::size_t>(joint)],
                                     world.JointAngle(joint), servo_));
  }

 private:
  double DueTime() const {
    return static_cast<double>(updates_) / servo_.update_rate;
  }

  Controller controller_;
  ServoOptions servo_;
  double step_;
  std::int64_t updates_ = 0;
};

}  // namespace

Trajectory Simulate(const Phenotype& phenotype, const Terrain& terrain,
                    const SimulationOptions& options) {
  assert(options.physics.step > 0 && options.sample_interval > 0 &&
         options.servo.update_rate > 0);
  const Assembly assembly = Assemble(phenotype.body);
  if (!FindOverlaps(assembly).empty()) {
    Trajectory nothing;
    nothing.outcome = Outcome::kOverlapping;
    nothing.interval = options.sample_interval;
    return nothing;
  }
  World world(assembly, terrain, options);
  Drive drive(phenotype, options);
  const auto samples = SampleSteps(options);
  Recorder recorder(world, static_cast<Eigen::Index>(samples.size()),
                    options.sample_interval);
  std::int64_t step = 0;
  for (const std::int64_t due : samples) {
    for (; step < due; ++step) {
      drive.Act(step, world);
      if (!world.Step())
        return recorder.Finish(world, Outcome::kUnstable, step + 1);
    }
    recorder.Sample(world, static_cast<double>(step) * options.physics.step);
  }
  return recorder.Finish(world, Outcome::kCompleted, step);
}

}  // namespace plsc
