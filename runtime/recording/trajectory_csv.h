#pragma once

// The samples of a simulated life as a table for other programs.

#include <string>

#include "sim/trajectory.h"

namespace plsc {

/// A header line, then a line a sample: time (s); core x, y, z and mass centre
/// x, y, z (m, world frame); roll, pitch, yaw (rad); contacts; the angle of
/// each joint (rad). Numbers are the shortest that read back equal.
std::string TrajectoryCsv(const Trajectory& trajectory);

}  // namespace plsc
