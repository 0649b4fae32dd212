#pragma once

// The controller of a robot as one C99 header that needs nothing but <math.h>:
// its tables and the functions that turn time, touch and joint angles into the
// speeds of servos, operation by operation as sim/controller does, so that
// outputs are equal bit for bit.

#include <string>

#include "runtime/exports/robot_model.h"

namespace plsc {

/// Its names begin with NamesInC of robot and environment.
std::string ControllerHeader(const RobotModel& model);

/// "climber_flat": what may be part of an identifier, the rest as '_'; so that
/// controllers of several robots and environments fit into one program.
std::string NamesInC(const RobotModel& model);

}  // namespace plsc
