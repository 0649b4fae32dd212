#include "sim/contact_law.h"

namespace plsc {
namespace {

/// kp in N/m and kd in N s/m of each surface.
struct Surface {
  double kp = 0;
  double kd = 0;
};

ContactLaw Between(const Surface& a, const Surface& b, double step) {
  const double kp = 1 / (1 / a.kp + 1 / b.kp);
  const double kd = a.kd + b.kd;
  // An implicit spring and damper, stable at any step.
  return {step * kp / (step * kp + kd), 1 / (step * kp + kd)};
}

}  // namespace

ContactLaw RobotOnGround(const PhysicsOptions& physics) {
  return Between({physics.robot_kp, physics.robot_kd},
                 {physics.ground_kp, physics.ground_kd}, physics.step);
}

ContactLaw RobotOnRobot(const PhysicsOptions& physics) {
  const Surface robot{physics.robot_kp, physics.robot_kd};
  return Between(robot, robot, physics.step);
}

}  // namespace plsc
