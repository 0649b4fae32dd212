#pragma once

// What a file has besides the robot.

#include <cstdint>

namespace plsc {

enum class Surroundings : std::uint8_t {
  kFloor,  ///< ground, light and physics: it can be simulated as it is
  kNone,   ///< nothing, to be put into a world of the user's
};

}  // namespace plsc
