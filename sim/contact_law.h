#pragma once

// How hard a contact pushes: stiffness and damping of the touching surfaces,
// turned into the two numbers a velocity-based solver takes. They are worked
// out for the step at hand, as the same pair of numbers would be another
// material at another step.

#include "sim/options.h"

namespace plsc {

/// Each step the contact removes the share `erp` of its depth and yields by
/// `cfm` m/s per N.
struct ContactLaw {
  double erp = 0;
  double cfm = 0;
};

/// Two surfaces in series: 1/kp add, as Gazebo (which the authors' program
/// runs in) combines them; but kd add. At 5 ms a robot on the ground gets
/// 1.26e-4 and 2.92e-7: it hardly rebounds, and depth lasts for tens of
/// seconds.
ContactLaw RobotOnGround(const PhysicsOptions& physics);
ContactLaw RobotOnRobot(const PhysicsOptions& physics);

}  // namespace plsc
