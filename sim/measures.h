#pragma once

// Behavioural descriptors of a season (paper, "Behavioral descriptors"; named
// as in the authors' program, measures.py, without its errors in durations
// and windows). Computed from samples; knows no body but its size.

#include <vector>

#include "sim/options.h"

namespace plsc {

struct Trajectory;

/// All zero, with is_valid false, for a trajectory that was not completed.
/// Speeds are between the first and the last sample; 50 m/s is the limit of
/// worlds (PhysicsOptions::max_speed).
struct Behaviour {
  bool is_valid = false;
  /// m/s, the paper's Speed (Eq. 3): progress along +y (the paper's x), which
  /// is the robot's front at birth and uphill; negative backwards.
  double displacement_velocity_hill = 0;
  /// m/s, at least 0: straight from start to end, in the xy plane.
  double displacement_velocity = 0;
  /// m/s, at least 0: along the path in the xy plane, from sample to sample
  /// (measures.py:velocity, whose window subtracts the wrong sample).
  double velocity = 0;
  /// 0.25 to 1: the paper's Balance (Eq. 4), of the core's roll and pitch.
  double head_balance = 0;
  /// At least 0: mean contact points a sample over Size. The authors sum over
  /// a window of 251 records, which they call unreliable themselves; the cap
  /// on contacts (sim/ground) bounds it, too.
  double contacts = 0;
  /// rad/s, at least 0: by how much joints turn otherwise than their servos are
  /// told, over steps and joints (sim/servo_errors). Not a number where a store
  /// of before has none, as core_turns.
  double servo_error_median = 0;
  double servo_error_worst = 0;
  /// 1/m, at least 0: revolutions of the core about a horizontal axis of its
  /// own, on the whole and not to and fro, for each metre of the path that
  /// velocity is of; what is shorter than a robot's length, 0.1 m, counts as
  /// that. A wheel of radius r has 1 / (2 pi r); robots that roll 1 to 2, those
  /// that row or drag themselves along hardly any.
  double core_turns = 0;
  /// m, world frame: where the measured point is at the end.
  double final_x = 0;
  double final_y = 0;
  double final_z = 0;
  /// rad, -pi to pi: the core's yaw at the end; 0 as at birth, to the left is
  /// more.
  double heading = 0;
  /// 0 to 1: straight from start to end over the path, as seen from above; 0
  /// without a path.
  double straightness = 0;
  /// rad, at least 0: changes of the core's yaw from sample to sample, the
  /// short way, without their signs.
  double turning = 0;
  /// J, at least 0: torque times speed of all servos and steps, without signs:
  /// what brakes costs as what drives. Not a number where a store of before has
  /// none, as are the six above and the two below.
  double energy = 0;
  /// At least 0: energy over weight and the straight way as seen from above, of
  /// which less than a robot's length, 0.1 m, counts as that. 0 without weight.
  double cost_of_transport = 0;
  /// m, at least 0: to the nearest target at the end, as seen from above. Not a
  /// number where there is none.
  double target_distance = 0;
};

/// A place of the ground as seen from above that robots may be meant to reach.
struct Target {
  double x = 0;  ///< m
  double y = 0;  ///< m, uphill

  friend bool operator==(const Target&, const Target&) = default;
};

/// `size`: modules that are no sensors, at least 1.
Behaviour Measure(const Trajectory& trajectory, int size, MeasuredPoint point,
                  const std::vector<Target>& targets = {});

}  // namespace plsc
