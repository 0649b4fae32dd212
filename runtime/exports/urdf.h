#pragma once

// A robot as URDF, the format of ROS. A tree of links, each with its frame at
// its joint. What URDF itself does not know (sensors, contacts) is in Gazebo's
// extension, and servos are transmissions of ros_control.

#include <string>

namespace plsc {

struct RobotModel;

std::string Urdf(const RobotModel& model);

}  // namespace plsc
