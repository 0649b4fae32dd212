#pragma once

// What a robot's inertial measurement unit tells of the ground before it
// develops. The one who senses is the core alone, the axiom of the genotype and
// the module that holds the IMU: put down level, it falls onto the ground,
// settles, and reads how far it leans. So the answer is the ground's, not that
// of limbs which a robot may lie on; docs/decisions/0007 weighs it.

#include "sim/options.h"
#include "sim/terrain.h"

namespace plsc {

struct Disturbance;
struct Spot;

/// rad, 0 to pi, between the core's own up and the vertical after it settled
/// at the spot, of `options` only physics and clearance matter. Its weight may
/// be without effect (no gravity): it stays level then.
double FeltInclination(const Terrain& terrain, const SimulationOptions& options,
                       const ImuOptions& imu, const Spot& spot);

/// rad, 0 to pi: what an erring unit tells of it.
double FeltWith(const Disturbance& disturbance, double inclination);

/// Where a core feels the ground of a life that starts at the origin: where
/// it is put down. A plane feels alike everywhere, to the last bit.
Spot FeltSpot(const Terrain& terrain, const Disturbance& disturbance);

}  // namespace plsc
