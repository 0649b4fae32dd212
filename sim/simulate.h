#pragma once

// One season: a phenotype on a terrain, from a fresh start at the origin.

#include "sim/options.h"
#include "sim/phenotype.h"
#include "sim/terrain.h"
#include "sim/trajectory.h"

namespace plsc {

/// A pure function of its arguments: the same bits on every call, whatever was
/// simulated before and in whatever thread. Robots that overlap in the rest
/// pose are not simulated (kOverlapping, no samples); robots without joints
/// are (they fall and rest).
Trajectory Simulate(const Phenotype& phenotype, const Terrain& terrain,
                    const SimulationOptions& options);

}  // namespace plsc
