// What the core alone would feel is found by physics and not from the ground's
// slope: on rough ground and among boxes it depends on how the core comes to
// rest. It falls and settles like a robot, in a world of its own, before the
// season and without taking part in it. acos is of the core's upright axis;
// rounding may take it beyond 1.

#include "sim/imu.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "sim/assembly.h"
#include "sim/disturbance.h"
#include "sim/maths/arc.h"
#include "sim/placement.h"
#include "sim/schedule.h"
#include "sim/world.h"

namespace plsc {

double FeltInclination(const Terrain& terrain, const SimulationOptions& options,
                       const ImuOptions& imu, const Spot& spot) {
  Body core;
  core.modules.emplace_back();
  const Assembly assembly = Assemble(core);
  World world(assembly, terrain, options,
              SetDown(assembly, Heading(spot.heading), spot, terrain,
                      options.start_clearance));
  const std::int64_t steps = NearestStep(imu.settling, options.physics.step);
  // Should the world go wrong, the last that was felt counts; the season will
  // go wrong in the same world and tell why.
  double felt = 0;
  for (std::int64_t step = 0; step < steps && world.Step(); ++step) {
    const double up = world.PoseOf(0).axes(2, 2);
    felt = Acos(std::clamp(up, -1.0, 1.0));
  }
  return felt;
}

double FeltWith(const Disturbance& disturbance, double inclination) {
  return std::min(std::abs(inclination + disturbance.lean), std::numbers::pi);
}

Spot FeltSpot(const Terrain& terrain, const Disturbance& disturbance) {
  const bool is_plane = terrain.type == TerrainType::kFlat ||
                        terrain.type == TerrainType::kTilted;
  return is_plane ? Spot{} : Displaced({}, disturbance);
}

}  // namespace plsc
