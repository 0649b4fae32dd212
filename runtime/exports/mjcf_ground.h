#pragma once

// The ground of a robot's world in MJCF: a plane, level or tilted, the boxes
// that stand in it, or a height field, and light to see them by.

#include <optional>
#include <vector>

#include "runtime/exports/robot_model.h"
#include "runtime/text/xml.h"

namespace plsc {

struct MjcfGround {
  std::optional<XmlElement> asset;  ///< of rough ground: MuJoCo 3 and later
  std::vector<XmlElement> geoms;    ///< of the world's body
};

MjcfGround GroundInMjcf(const RobotModel& model);

}  // namespace plsc
