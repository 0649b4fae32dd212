#pragma once

// Steps and obstacles as upright boxes that stand in the plane z = 0. Found
// by where one looks, never listed: the ground has no end.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "sim/terrain.h"

namespace plsc {

/// Sides along the world's axes.
struct StaticBox {
  Eigen::Vector3d centre;  ///< m
  Eigen::Vector3d size;    ///< m, full lengths of the sides
};

/// No part of an obstacle is nearer to the origin, m: a core is 63 mm from its
/// centre to a corner, and a limb of two modules fits beside it.
inline constexpr double kClearRadius = 0.15;

/// How far boxes reach below the plane, m. Deeper than anything sinks in, so
/// that what is pushed out is pushed up or aside.
inline constexpr double kBoxDepth = 1;

/// Appends the boxes of `terrain` that meet `bounds` (world frame); none on
/// terrains without boxes. Always in the same order for the same place.
void AppendStaticBoxes(const Terrain& terrain,
                       const Eigen::AlignedBox3d& bounds,
                       std::vector<StaticBox>& boxes);

}  // namespace plsc
