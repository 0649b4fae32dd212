#include "runtime/scenario/scenario_terrain.h"

#include <fmt/format.h>

#include <cassert>
#include <numbers>
#include <vector>

namespace plsc {

namespace {

// Beyond 89 degrees the ground is a wall.
constexpr Quantity kTilt = {Dimension::kAngle, 0, 89 * std::numbers::pi / 180};
constexpr Quantity kHeight = {Dimension::kLength, 0, 10};
// Stairs of no height would be without end.
constexpr Quantity kStepHeight = {Dimension::kLength, 0, 10, true};
// Narrower than a joint's frame (22 mm), ground is texture, which friction
// stands for.
constexpr Quantity kWidth = {Dimension::kLength, 0.02, 1000};

std::uint64_t ReadSeed(YamlMap& map, std::uint64_t otherwise) {
  const auto seed = map.Find("seed");
  return seed ? seed->Unsigned().value_or(otherwise) : otherwise;
}

Rough ReadRough(YamlMap map) {
  Rough rough;
  rough.seed = ReadSeed(map, rough.seed);
  rough.amplitude = map.Number("amplitude", rough.amplitude, kHeight);
  rough.wavelength = map.Number("wavelength", rough.wavelength, kWidth);
  map.Close();
  return rough;
}

Steps ReadSteps(YamlMap map) {
  Steps steps;
  steps.height = map.Number("height", steps.height, kStepHeight);
  steps.depth = map.Number("depth", steps.depth, kWidth);
  steps.count = map.Int("count", steps.count, 1, 1000);
  map.Close();
  return steps;
}

Obstacles ReadObstacles(YamlMap map) {
  Obstacles obstacles;
  const std::size_t errors = map.place().error_count();
  obstacles.seed = ReadSeed(map, obstacles.seed);
  obstacles.spacing = map.Number("spacing", obstacles.spacing, kWidth);
  obstacles.size = map.Number("size", obstacles.size, kWidth);
  obstacles.height = map.Number("height", obstacles.height, kHeight);
  if (map.place().error_count() == errors && obstacles.size > obstacles.spacing)
    map.place().Report(Code::kMisfit,
                       fmt::format("obstacles of {} m do not fit squares of "
                                   "{} m",
                                   obstacles.size, obstacles.spacing),
                       "make 'spacing' at least 'size'");
  map.Close();
  return obstacles;
}

/// `rough` alone has the default parameters, as `flat` has none.
Terrain ReadName(const YamlValue& value) {
  Terrain terrain;
  const auto type = value.Choice(kTerrainNames);
  if (!type) return terrain;
  terrain.type = *type;
  if (terrain.type == TerrainType::kTilted)
    value.Report(Code::kMissingKey, "expected the tilt of the ground",
                 "write 'terrain: {tilted: 5 deg}'");
  return terrain;
}

}  // namespace

Terrain ReadTerrain(const YamlValue& value) {
  if (!value.is_map()) return ReadName(value);
  YamlMap map = *value.Map("a terrain");
  Terrain terrain;
  if (map.Find("flat")) {
    value.Report(Code::kWrongKind,
                 "expected 'flat' alone: it has no parameters",
                 "write 'terrain: flat'");
    map.TakeAll();
    return terrain;
  }
  int named = 0;
  if (const auto tilt = map.Find("tilted")) {
    terrain.type = TerrainType::kTilted;
    terrain.tilt = tilt->Number(kTilt).value_or(0);
    ++named;
  }
  // Each reader is asked only for the map that is there.
  const auto find = [&](TerrainType type) -> std::optional<YamlMap> {
    const auto of = map.Find(NameIn(kTerrainNames, type));
    if (!of) return std::nullopt;
    terrain.type = type;
    ++named;
    return of->Map("its parameters");
  };
  if (auto rough = find(TerrainType::kRough))
    terrain.rough = ReadRough(std::move(*rough));
  if (auto steps = find(TerrainType::kSteps))
    terrain.steps = ReadSteps(std::move(*steps));
  if (auto obstacles = find(TerrainType::kObstacles))
    terrain.obstacles = ReadObstacles(std::move(*obstacles));
  const std::size_t errors = value.error_count();
  map.Close();
  // Of an unknown kind that is said already.
  if (named != 1 && value.error_count() == errors)
    value.Report(Code::kMissingKey,
                 fmt::format("expected one kind of ground, found {}", named),
                 "write '{tilted: 5 deg}', '{rough: {...}}', '{steps: {...}}' "
                 "or '{obstacles: {...}}'");
  return terrain;
}

std::string PrintTerrain(const Terrain& terrain) {
  const auto length = [](double value) {
    return PrintQuantity(value, Dimension::kLength);
  };
  switch (terrain.type) {
    case TerrainType::kFlat:
      return "flat";
    case TerrainType::kTilted:
      return fmt::format("{{tilted: {}}}",
                         PrintQuantity(terrain.tilt, Dimension::kAngle));
    case TerrainType::kRough:
      return fmt::format(
          "{{rough: {{seed: {}, amplitude: {}, wavelength: {}}}}}",
          terrain.rough.seed, length(terrain.rough.amplitude),
          length(terrain.rough.wavelength));
    case TerrainType::kSteps:
      return fmt::format("{{steps: {{height: {}, depth: {}, count: {}}}}}",
                         length(terrain.steps.height),
                         length(terrain.steps.depth), terrain.steps.count);
    case TerrainType::kObstacles:
      return fmt::format(
          "{{obstacles: {{seed: {}, spacing: {}, size: {}, height: {}}}}}",
          terrain.obstacles.seed, length(terrain.obstacles.spacing),
          length(terrain.obstacles.size), length(terrain.obstacles.height));
  }
  assert(false);
  return "";
}

}  // namespace plsc
