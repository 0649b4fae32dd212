#pragma once

// A robot as JSON of our own, for programs that know none of the other
// formats: everything that they hold, and what they cannot (docs/exports.md).

#include <string>

namespace plsc {

struct RobotModel;

/// Keys: plsc_robot (version of this layout), name, environment, mass, start,
/// links, joints, sensors, never_collide, physics, controller.
std::string RobotJson(const RobotModel& model);

}  // namespace plsc
