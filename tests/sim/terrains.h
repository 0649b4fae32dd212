#pragma once

// One ground of each kind.

#include <cmath>
#include <vector>

#include "sim/terrain.h"

namespace plsc::test {

inline Terrain Slope(double degrees) {
  Terrain terrain;
  terrain.type = TerrainType::kTilted;
  terrain.tilt = degrees * M_PI / 180;
  return terrain;
}

inline Terrain RoughGround(std::uint64_t seed, double amplitude,
                           double wavelength) {
  Terrain terrain;
  terrain.type = TerrainType::kRough;
  terrain.rough = {seed, amplitude, wavelength};
  return terrain;
}

inline Terrain Stairs(double height, double depth, int count) {
  Terrain terrain;
  terrain.type = TerrainType::kSteps;
  terrain.steps = {height, depth, count};
  return terrain;
}

inline Terrain ObstacleField(std::uint64_t seed, double spacing, double size,
                             double height) {
  Terrain terrain;
  terrain.type = TerrainType::kObstacles;
  terrain.obstacles = {seed, spacing, size, height};
  return terrain;
}

inline std::vector<Terrain> AllTerrains() {
  return {Terrain{}, Slope(5), RoughGround(1, 0.02, 0.2), Stairs(0.02, 0.3, 10),
          ObstacleField(1, 0.2, 0.1, 0.02)};
}

}  // namespace plsc::test
