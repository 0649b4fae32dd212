#pragma once

// Contacts of one step, wherever they come from: a point, three directions
// along which it may be pushed, and who pushes whom.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

namespace plsc::articulated {

inline constexpr int kGround = -1;

/// Contacts that there is memory for from the start, of a robot of so many
/// links: four each on the ground, and more between links than robots of 15
/// modules were seen to have.
inline std::size_t ReservedContacts(std::size_t links) {
  return 64 + 4 * links;
}

struct Contact {
  int link = 0;           ///< pushed along the normal
  int other = kGround;    ///< link that is pushed the other way
  Eigen::Vector3d point;  ///< m, from the base's centre, ground axes
  /// The normal, then two across it, along which friction acts: unit.
  std::array<Eigen::Vector3d, 3> directions;
  double depth = 0;          ///< m
  bool is_on_plane = false;  ///< directions are z, x and y
  /// Tells the point from all others of the robot, and stays while they touch.
  std::uint64_t key = 0;
};

}  // namespace plsc::articulated
