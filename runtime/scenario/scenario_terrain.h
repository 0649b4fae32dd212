#pragma once

// A season's ground in YAML: `flat`, `{tilted: 5 deg}`, `{rough: {seed: 1,
// amplitude: 1 cm, wavelength: 20 cm}}`, and so on.

#include <string>

#include "grammar/enum_names.h"
#include "runtime/text/yaml_reader.h"
#include "sim/terrain.h"

namespace plsc {

inline constexpr EnumNames<TerrainType, 5> kTerrainNames{
    {{TerrainType::kFlat, "flat"},
     {TerrainType::kTilted, "tilted"},
     {TerrainType::kRough, "rough"},
     {TerrainType::kSteps, "steps"},
     {TerrainType::kObstacles, "obstacles"}}};

/// What is wrong is reported at its place, and replaced by a default.
Terrain ReadTerrain(const YamlValue& value);

/// On one line, every parameter written out.
std::string PrintTerrain(const Terrain& terrain);

}  // namespace plsc
