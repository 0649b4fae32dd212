#pragma once

// Where a robot that leaves plsc lives: the ground, physics, servo and
// controller of its season.

#include <vector>

#include "runtime/cli/robots/robot_source.h"
#include "sim/options.h"
#include "sim/terrain.h"

namespace plsc::cli {

struct RobotSetting {
  SimulationOptions options;
  Terrain terrain;
};

/// By the robot's environments. Of a robot without scenario: the default
/// profile's, on flat ground. An environment that is no season's is put on flat
/// ground, with the constants of the first season, which is said on io.err.
std::vector<RobotSetting> SettingsOf(const RobotFound& robot, Io& io);

}  // namespace plsc::cli
