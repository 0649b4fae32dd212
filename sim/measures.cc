// The paper's behavioural descriptors from samples, under the names of
// measures.py. Two of its defects are left out: its durations count sub-second
// time in tenths (up to 1.8 % wrong), and its window of records subtracts the
// newest where it means the oldest. Sums run over samples in order of time.
//
// core_turns, which the authors do not have, tells rolling from all else. From
// sample to sample the core turns by a vector, of which what is vertical is
// taken away: to turn on the spot is not to roll. The rest is seen from the
// core and summed up with its sign. A wheel turns about an axis that is fixed
// in it, whichever way its path curves, so all of it adds up; what rocks as it
// rows turns back what it turned, and nothing is left; nor is of a sum of
// sizes, which would take shaking for rolling. On a slope of a degrees an
// upright robot that turns on the spot has sin^2 a of it, 0.8 % at 5 degrees.
// To turn by more than half a turn between samples (0.2 s) is taken for less;
// servos of 1 rad/s are far from it.

#include "sim/measures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/maths/arc.h"
#include "sim/maths/hypot.h"
#include "sim/maths/sine.h"
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

/// The core's axes as columns, of its roll, pitch and yaw (sim/recorder).
Eigen::Matrix3d AxesOf(const Eigen::Vector3d& orientation) {
  const SineCosine roll = SinCos(orientation.x());
  const SineCosine pitch = SinCos(orientation.y());
  const SineCosine yaw = SinCos(orientation.z());
  Eigen::Matrix3d about_x = Eigen::Matrix3d::Identity();
  about_x.bottomRightCorner<2, 2>() << roll.cosine, -roll.sine, roll.sine,
      roll.cosine;
  Eigen::Matrix3d about_y = Eigen::Matrix3d::Identity();
  about_y(0, 0) = about_y(2, 2) = pitch.cosine;
  about_y(0, 2) = pitch.sine;
  about_y(2, 0) = -pitch.sine;
  Eigen::Matrix3d about_z = Eigen::Matrix3d::Identity();
  about_z.topLeftCorner<2, 2>() << yaw.cosine, -yaw.sine, yaw.sine, yaw.cosine;
  return about_z * about_y * about_x;
}

/// rad, about the world's axes: how one comes to be the other, the short way.
Eigen::Vector3d TurnBetween(const Eigen::Matrix3d& from,
                            const Eigen::Matrix3d& to) {
  const Eigen::Matrix3d turn = to * from.transpose();
  const Eigen::Vector3d twice_sine(turn(2, 1) - turn(1, 2),
                                   turn(0, 2) - turn(2, 0),
                                   turn(1, 0) - turn(0, 1));
  const double size = twice_sine.norm();
  if (size == 0) return Eigen::Vector3d::Zero();
  return Atan2(size, turn.trace() - 1) / size * twice_sine;
}

/// Whole and parts, of the core about a horizontal axis of its own.
double Turns(const Eigen::Matrix3Xd& orientation) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  if (orientation.cols() == 0) return 0;
  Eigen::Matrix3d before = AxesOf(orientation.col(0));
  for (Eigen::Index i = 1; i < orientation.cols(); ++i) {
    const Eigen::Matrix3d axes = AxesOf(orientation.col(i));
    Eigen::Vector3d turn = TurnBetween(before, axes);
    turn.z() = 0;
    // As seen halfway, nearly: both ends see the same unless it turns upright,
    // too.
    sum += (before.transpose() * turn + axes.transpose() * turn) / 2;
    before = axes;
  }
  return sum.norm() / (2 * std::numbers::pi);
}

// m: a robot that falls over where it stands turns by a quarter on no path, and
// spends what it has on no way.
constexpr double kLeastPath = 0.1;

/// Changes of the yaw, each the short way.
double Turning(const Eigen::Matrix3Xd& orientation) {
  double sum = 0;
  for (Eigen::Index i = 1; i < orientation.cols(); ++i) {
    const double change =
        std::abs(orientation(2, i) - orientation(2, i - 1));  // below 2 pi
    sum += std::min(change, 2 * std::numbers::pi - change);
  }
  return sum;
}

double TargetDistance(const Eigen::Vector3d& place,
                      const std::vector<Target>& targets) {
  if (targets.empty()) return std::numeric_limits<double>::quiet_NaN();
  double least = std::numeric_limits<double>::infinity();
  for (const Target& target : targets)
    least = std::min(least, Hypot(target.x - place.x(), target.y - place.y()));
  return least;
}

void MeasureEnd(const Trajectory& trajectory, const Eigen::Vector3d& place,
                const std::vector<Target>& targets, Behaviour& behaviour) {
  behaviour.final_x = place.x();
  behaviour.final_y = place.y();
  behaviour.final_z = place.z();
  const Eigen::Matrix3Xd& orientation = trajectory.core_orientation;
  behaviour.heading = orientation(2, orientation.cols() - 1);
  behaviour.target_distance = TargetDistance(place, targets);
}

}  // namespace

Behaviour Measure(const Trajectory& trajectory, int size, MeasuredPoint point,
                  const std::vector<Target>& targets) {
  assert(size >= 1);
  Behaviour behaviour;
  const Eigen::Index last = trajectory.time.size() - 1;
  if (trajectory.outcome != Outcome::kCompleted || last < 0) return behaviour;
  behaviour.is_valid = true;
  behaviour.head_balance = Balance(trajectory.core_orientation);
  behaviour.contacts =
      trajectory.contacts.cast<double>().mean() / static_cast<double>(size);
  behaviour.servo_error_median = trajectory.servo_error_median;
  behaviour.servo_error_worst = trajectory.servo_error_worst;
  behaviour.energy = trajectory.energy;
  const Eigen::Matrix3Xd& places = point == MeasuredPoint::kCore
                                       ? trajectory.core_position
                                       : trajectory.mass_centre;
  MeasureEnd(trajectory, places.col(last), targets, behaviour);
  const double time = trajectory.time(last) - trajectory.time(0);
  // A life without length has no speed.
  if (time <= 0) return behaviour;
  const Eigen::Vector3d way = places.col(last) - places.col(0);
  behaviour.displacement_velocity_hill = way.y() / time;
  behaviour.displacement_velocity = way.head<2>().norm() / time;
  const double path = PathLength(places);
  const double straight = way.head<2>().norm();
  // Rounding may make a straight path a bit shorter than its ends are apart.
  if (path > 0) behaviour.straightness = std::min(straight / path, 1.0);
  behaviour.turning = Turning(trajectory.core_orientation);
  if (trajectory.weight > 0)
    behaviour.cost_of_transport =
        trajectory.energy /
        (trajectory.weight * std::max(straight, kLeastPath));
  behaviour.velocity = path / time;
  behaviour.core_turns =
      Turns(trajectory.core_orientation) / std::max(path, kLeastPath);
  return behaviour;
}

}  // namespace plsc
