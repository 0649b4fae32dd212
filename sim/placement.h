#pragma once

// Where a robot is put down. It rests: its lowest point is a hair above the
// ground, it is aligned with the ground's plane and heads where it is told, so
// that a life starts neither with a fall nor inside of something.

#include <Eigen/Core>

#include "sim/assembly.h"
#include "sim/disturbance.h"
#include "sim/options.h"
#include "sim/terrain.h"

namespace plsc {

/// Of an Assembly in the world: its origin, the core's centre, comes to lie at
/// `position`, its axes along the columns of `axes`.
struct Placement {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();

  /// Of a point of the assembly.
  Eigen::Vector3d operator()(const Eigen::Vector3d& point) const {
    return position + axes * point;
  }
};

/// A place on the map and a direction.
struct Spot {
  double x = 0, y = 0;  ///< m
  double heading = 0;   ///< rad, counter-clockwise from +y (uphill)

  friend bool operator==(const Spot&, const Spot&) = default;
};

/// Where a body comes to stand that is meant for the spot.
Spot Displaced(const Spot& spot, const Disturbance& disturbance);

/// The turn about the vertical by `angle`, rad.
Eigen::Matrix3d Heading(double angle);

/// The turn that takes the vertical to the normal of the ground's plane by the
/// shortest way.
Eigen::Matrix3d AlignedAxes(const Terrain& terrain);

/// m, along the vertical, by which the robot clears the ground; negative if
/// any part is below. The points of BoxCorners that contacts use are held
/// against planes and rough ground; steps and obstacles count where the upright
/// box around a part is above them, which is never too little.
double Gap(const Assembly& assembly, const Placement& placement,
           const Terrain& terrain);

/// The robot in the given attitude above the spot, cleared by `clearance`.
Placement SetDown(const Assembly& assembly, const Eigen::Matrix3d& axes,
                  const Spot& spot, const Terrain& terrain, double clearance);

/// Where a life starts: as SimulationOptions say.
Placement StartOf(const Assembly& assembly, const Terrain& terrain,
                  const SimulationOptions& options, const Spot& spot);

/// Where the core of a robot stands and looks; a core on end looks where its
/// right side tells.
Spot SpotOf(const Placement& core);

}  // namespace plsc
