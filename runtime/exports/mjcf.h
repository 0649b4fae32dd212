#pragma once

// A robot as MJCF, the format of MuJoCo: bodies with their boxes, hinges,
// velocity servos with our torque, touch sensors, accelerometer and gyroscope;
// on a floor, where it starts as in our simulation. Written for MuJoCo 2.2 and
// later.

#include <string>

#include "runtime/exports/surroundings.h"

namespace plsc {

struct RobotModel;

std::string Mjcf(const RobotModel& model, Surroundings surroundings);

}  // namespace plsc
