#pragma once

// What a robot's inertial measurement unit tells of the ground before it
// develops. The one who senses is the core alone, the axiom of the genotype and
// the module that holds the IMU: put down level, it falls onto the ground,
// settles, and reads how far it leans. So the answer is the ground's, not that
// of limbs which a robot may lie on; docs/decisions/0007 weighs it.

#include "sim/options.h"
#include "sim/placement.h"
#include "sim/terrain.h"

namespace plsc {

struct ImuOptions {
  /// rad; leaning by more is inclined. Midway between the paper's grounds, 0
  /// and 5 degrees. Up to
  /// 10 degrees a core settles to within 1.5 degrees of its ground.
  double threshold = 0.04363323129985824;
  double settling = 1;  ///< s, from being put down to the reading

  friend bool operator==(const ImuOptions&, const ImuOptions&) = default;
};

/// rad, 0 to pi, between the core's own up and the vertical after it settled
/// at the spot, of `options` only physics and clearance matter. Its weight may
/// be without effect (no gravity): it stays level then.
double FeltInclination(const Terrain& terrain, const SimulationOptions& options,
                       const ImuOptions& imu, const Spot& spot);

}  // namespace plsc
