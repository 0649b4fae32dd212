#pragma once

// The relief under a robot's path as numbers, for pages that show it without
// the code that makes it: what rises from the plane, as far as the robot came
// and somewhat beyond. The plane itself (and its tilt) is in the recording.

#include <Eigen/Geometry>
#include <string>

#include "runtime/recording/recording.h"

namespace plsc {

/// m around a path: more than a camera near the robot sees sharply.
inline constexpr double kGroundMargin = 1.5;
/// m from where the robot began. Who gets farther in a life (1 cm/s for half an
/// hour are 18 m) was thrown there, and is not followed with relief.
inline constexpr double kFarthestGround = 20;
/// What a page holds of relief, a season: heights take 1 to 3 bytes each.
inline constexpr int kMaxHeights = 160 * 160;
inline constexpr int kMaxBoxes = 4000;

/// m, world frame, seen from above; around the origin if nothing moved.
Eigen::AlignedBox2d GroundExtent(const RecordedSeason& season);

/// An object with one key, or none on planes:
/// "heights": {"x", "y" of the first, "spacing" (m), "columns" (along x),
/// "rows", and a track of one row a y}, or
/// "boxes": a track of the rows x, y of the centre, width, length, top (m).
std::string GroundJson(const RecordedSeason& season);

}  // namespace plsc
