#pragma once

// A robot as SDFormat 1.7, the format of Gazebo: a model with its contacts'
// constants, contact sensors, IMU and a speed command a joint, in a world with
// our ground and step.

#include <string>

#include "runtime/exports/surroundings.h"

namespace plsc {

struct RobotModel;

/// A world that holds the model, or the model alone.
std::string Sdf(const RobotModel& model, Surroundings surroundings);

}  // namespace plsc
