#pragma once

// From one ground to the next in one life: the ground changes under a robot
// that stands on it. Planes tilt about the x axis through the origin and carry
// everything on them along, so that the robot keeps its place on the ground,
// its pose and its speed as seen from there.

#include "sim/phenotype.h"
#include "sim/simulate.h"
#include "sim/terrain.h"

namespace plsc {

struct Passage {
  Terrain from, to;
  double clearance = 1e-4;  ///< m, where a robot has to be put down anew
};

/// The state as it is after the ground has turned. Where one of the two is no
/// plane, the robot is also raised or lowered until its lowest point is
/// `clearance` above the new ground.
LifeState Carry(const LifeState& state, const Phenotype& phenotype,
                const Passage& passage);

}  // namespace plsc
