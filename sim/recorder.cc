#include "sim/recorder.h"

#include <cassert>
#include <utility>

#include "sim/maths/arc.h"
#include "sim/maths/hypot.h"
#include "sim/world.h"

namespace plsc {

Eigen::Vector3d RollPitchYaw(const Eigen::Matrix3d& axes) {
  // Not asin: rounding may take an element of a rotation beyond 1.
  const double pitch = Atan2(-axes(2, 0), Hypot(axes(0, 0), axes(1, 0)));
  return {Atan2(axes(2, 1), axes(2, 2)), pitch, Atan2(axes(1, 0), axes(0, 0))};
}

Recorder::Recorder(const World& world, Eigen::Index samples, double interval) {
  trajectory_.interval = interval;
  trajectory_.time.resize(samples);
  trajectory_.core_position.resize(3, samples);
  trajectory_.core_orientation.resize(3, samples);
  trajectory_.mass_centre.resize(3, samples);
  trajectory_.joint_angle.resize(world.joints(), samples);
  trajectory_.contacts.resize(samples);
}

void Recorder::Sample(const World& world, double time) {
  assert(count_ < trajectory_.time.size());
  trajectory_.time(count_) = time;
  trajectory_.core_position.col(count_) = world.CorePosition();
  trajectory_.core_orientation.col(count_) = RollPitchYaw(world.PoseOf(0).axes);
  trajectory_.mass_centre.col(count_) = world.MassCentre();
  for (int joint = 0; joint < world.joints(); ++joint)
    trajectory_.joint_angle(joint, count_) = world.JointAngle(joint);
  trajectory_.contacts(count_) = world.contacts();
  ++count_;
}

Trajectory Recorder::Finish(const World& world, std::int64_t steps) {
  Trajectory result = std::move(trajectory_);
  result.outcome = world.failure().outcome;
  result.reason = world.failure().reason;
  result.steps = steps;
  result.state_hash = world.Hash();
  result.solver_warnings = world.solver_warnings();
  result.time.conservativeResize(count_);
  result.core_position.conservativeResize(3, count_);
  result.core_orientation.conservativeResize(3, count_);
  result.mass_centre.conservativeResize(3, count_);
  result.joint_angle.conservativeResize(result.joint_angle.rows(), count_);
  result.contacts.conservativeResize(count_);
  return result;
}

}  // namespace plsc
