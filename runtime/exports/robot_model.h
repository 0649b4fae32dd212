#pragma once

// A developed robot as other programs know robots: named links, joints, servos
// and sensors, and the world that it is simulated in. The one description that
// every format of this folder is written from; its numbers are those of the
// simulator (sim/assembly, sim/options), none is worked out again. Knows no
// format.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sim/assembly.h"
#include "sim/options.h"
#include "sim/phenotype.h"
#include "sim/placement.h"
#include "sim/terrain.h"

namespace plsc {

/// A touch sensor feels what meets its box.
struct TouchSensor {
  std::string name;      ///< "touch_1s2"
  int module = 0;        ///< index into Body::modules
  std::size_t link = 0;  ///< index into Assembly::links
  std::size_t box = 0;   ///< index into Link::boxes
};

/// Lengths, masses and inertias as in Assembly: in the robot's frame, the
/// core's centre its origin, x right, y front, z up, all joints at 0.
struct RobotModel {
  std::string name;         ///< of the genotype
  std::string environment;  ///< any text
  std::string prefix;       ///< that all names of parts below begin with
  Phenotype phenotype;
  Assembly assembly;
  SimulationOptions options;
  Terrain terrain;
  Placement start;                  ///< as `options` say
  std::string imu;                  ///< "imu", at the core's centre
  std::vector<std::string> links;   ///< "core", "link_3"; by Assembly::links
  std::vector<std::string> joints;  ///< "joint_3"; by Assembly::hinges
  std::vector<std::string> servos;  ///< "servo_3"; by Assembly::hinges
  std::vector<TouchSensor> touch_sensors;  ///< in order of modules
};

/// Whose body it is: names for people, which may be any text.
struct RobotTitle {
  std::string name;
  std::string environment;
  std::string prefix = {};  ///< of the names of parts, letters of any format
};

RobotModel ModelOf(const RobotTitle& title, const Phenotype& phenotype,
                   const SimulationOptions& options,
                   const Terrain& terrain = {});

/// How the default profile simulates a robot on flat ground.
SimulationOptions ExportedOptions();

/// "core_1", "brick_3", "frame_2", "servo_2", "plate_2", "sensor_1s2".
std::string BoxName(const Body& body, const Box& box);
/// Likewise, behind the model's prefix.
std::string BoxName(const RobotModel& model, const Box& box);

/// m, of a link's own frame, about which it turns: its hinge's anchor, the
/// core's centre for link 0. Unrotated.
Eigen::Vector3d FrameOf(const Assembly& assembly, std::size_t link);

/// Red, green, blue, 0 to 1, of the authors' 3-D models (plasticoding.py:448).
std::array<double, 3> AuthorsColour(ModuleType type);

/// What every file tells its reader: whose robot, units, frame, ground and
/// physics, and how plsc drives the servos. A few lines without an end.
std::string NotesOn(const RobotModel& model);

}  // namespace plsc
