#pragma once

// A recorded robot as seen from straight above: the outline of every box in
// its true pose. Plane geometry for pictures.

#include <Eigen/Core>
#include <vector>

#include "runtime/recording/recording.h"

namespace plsc {

struct Outline {
  ModuleType type = ModuleType::kCore;
  Part part = Part::kCore;
  std::vector<Eigen::Vector2d> corners;  ///< m, world frame, convex, counter-
                                         ///< clockwise
};

/// In the order to draw them, lower ones first. Without samples, the robot at
/// rest with its core at the origin.
std::vector<Outline> TopView(const RecordedSeason& season, Eigen::Index sample);

/// The corners of the smallest convex polygon around the points,
/// counter-clockwise.
std::vector<Eigen::Vector2d> ConvexHull(std::vector<Eigen::Vector2d> points);

}  // namespace plsc
