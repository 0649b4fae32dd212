#pragma once

// The ground a season is lived on. World frame: x right, y front and uphill,
// z up; gravity along -z; the ground passes through the origin. (The paper
// calls the uphill axis x.) Every kind is without end. Data only: sim/ground,
// sim/height_field and sim/static_boxes are its geometry.

#include <cstdint>

namespace plsc {

enum class TerrainType : std::uint8_t {
  kFlat,
  kTilted,
  kRough,
  kSteps,
  kObstacles,
};

/// Smooth hills, drawn from a seed.
struct Rough {
  std::uint64_t seed = 1;
  double amplitude = 0.01;  ///< m, hills and hollows about the mean
  double wavelength = 0.2;  ///< m, between lattice points of the noise

  friend bool operator==(const Rough&, const Rough&) = default;
};

/// Stairs that rise along +y; flat before the first and after the last.
struct Steps {
  double height = 0.01;  ///< m, of each
  double depth = 0.3;    ///< m, of each; the first rises at y = depth
  int count = 20;

  friend bool operator==(const Steps&, const Steps&) = default;
};

/// Boxes on a plane: one in each square of a lattice, but none near the
/// origin.
struct Obstacles {
  std::uint64_t seed = 1;
  double spacing = 0.3;  ///< m, side of the squares
  double size = 0.1;  ///< m, of the largest, seen from above; at most spacing
  double height = 0.01;  ///< m, of the highest

  friend bool operator==(const Obstacles&, const Obstacles&) = default;
};

struct Terrain {
  TerrainType type = TerrainType::kFlat;
  double tilt = 0;           ///< rad, kTilted only; the plane rises along +y
  Rough rough = {};          ///< kRough only
  Steps steps = {};          ///< kSteps only
  Obstacles obstacles = {};  ///< kObstacles only

  friend bool operator==(const Terrain&, const Terrain&) = default;
};

}  // namespace plsc
