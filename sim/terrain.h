#pragma once

// The ground a season is lived on. World frame: x right, y front and uphill,
// z up; gravity along -z; the ground passes through the origin. (The paper
// calls the uphill axis x.)

#include <cstdint>

namespace plsc {

enum class TerrainType : std::uint8_t { kFlat, kTilted };

struct Terrain {
  TerrainType type = TerrainType::kFlat;
  double tilt = 0;  ///< rad, kTilted only; the plane rises along +y

  friend bool operator==(const Terrain&, const Terrain&) = default;
};

}  // namespace plsc
