// The paper's behavioural descriptors from samples, under the names of
// measures.py. Two of its defects are left out: its durations count sub-second
// time in tenths (up to 1.8 % wrong), and its window of records subtracts the
// newest where it means the oldest. Sums run over samples in order of time.

#include "sim/measures.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "sim/trajectory.h"

namespace plsc {
namespace {

/// m, as seen from above, from sample to sample.
double PathLength(const Eigen::Matrix3Xd& position) {
  double length = 0;
  for (Eigen::Index i = 1; i < position.cols(); ++i)
    length += (position.col(i) - position.col(i - 1)).head<2>().norm();
  return length;
}

/// Eq. 4: 1 without any roll and pitch. Each can be pi at most but pitch only
/// half of that, so the least is 0.25.
double Balance(const Eigen::Matrix3Xd& orientation) {
  const double samples = static_cast<double>(orientation.cols());
  const double tilt = orientation.topRows<2>().cwiseAbs().sum();
  return 1 - tilt / (samples * 2 * std::numbers::pi);
}

}  // namespace

Behaviour Measure(const Trajectory& trajectory, int size, MeasuredPoint point) {
  assert(size >= 1);
  Behaviour behaviour;
  const Eigen::Index last = trajectory.time.size() - 1;
  if (trajectory.outcome != Outcome::kCompleted || last < 0) return behaviour;
  behaviour.is_valid = true;
  behaviour.head_balance = Balance(trajectory.core_orientation);
  behaviour.contacts =
      trajectory.contacts.cast<double>().mean() / static_cast<double>(size);
  const double time = trajectory.time(last) - trajectory.time(0);
  // A life without length has no speed.
  if (time <= 0) return behaviour;
  const Eigen::Matrix3Xd& places = point == MeasuredPoint::kCore
                                       ? trajectory.core_position
                                       : trajectory.mass_centre;
  const Eigen::Vector3d way = places.col(last) - places.col(0);
  behaviour.displacement_velocity_hill = way.y() / time;
  behaviour.displacement_velocity = way.head<2>().norm() / time;
  behaviour.velocity = PathLength(places) / time;
  return behaviour;
}

}  // namespace plsc
