#include "runtime/exports/exported_ground.h"

#include "runtime/scenario/scenario_terrain.h"
#include "sim/height_field.h"

namespace plsc {

namespace {

// Points to a wavelength: straight lines between them are off by 2 % of the
// amplitude.
constexpr double kPointsToWave = 8;
// To either side of the start: 5 m of the usual hills (20 cm), and a file of
// 1.3 MB.
constexpr int kPointsToSide = 200;

// Squares of the lattice to either side, at most 2,500 boxes: 7.5 m of the
// usual obstacles (30 cm).
constexpr double kSquaresToSide = 24.5;

// Above any step or obstacle, m.
constexpr double kAbove = 1e5;

Eigen::MatrixXd HeightsOf(const Rough& rough, double spacing) {
  const HeightField field(rough);
  constexpr Eigen::Index kPoints = 2 * kPointsToSide + 1;
  Eigen::MatrixXd heights(kPoints, kPoints);
  const auto place = [&](Eigen::Index i) {
    return spacing * static_cast<double>(i - kPointsToSide);
  };
  for (Eigen::Index row = 0; row < kPoints; ++row)
    for (Eigen::Index column = 0; column < kPoints; ++column)
      heights(row, column) = field.At(place(column), place(row)).height;
  return heights;
}

std::vector<StaticBox> BoxesWithin(const Terrain& terrain, double x, double y) {
  const Eigen::AlignedBox3d bounds(Eigen::Vector3d(-x, -y, -kBoxDepth),
                                   Eigen::Vector3d(x, y, kAbove));
  std::vector<StaticBox> boxes;
  AppendStaticBoxes(terrain, bounds, boxes);
  return boxes;
}

}  // namespace

double ExportedGround::lowest() const {
  return heights.size() == 0 ? 0 : heights.minCoeff();
}

double ExportedGround::highest() const {
  return heights.size() == 0 ? 0 : heights.maxCoeff();
}

ExportedGround GroundOf(const Terrain& terrain) {
  ExportedGround ground;
  switch (terrain.type) {
    case TerrainType::kFlat:
    case TerrainType::kTilted:
      break;
    case TerrainType::kRough: {
      const double spacing = terrain.rough.wavelength / kPointsToWave;
      ground.reach = kPointsToSide * spacing;
      ground.heights = HeightsOf(terrain.rough, spacing);
      break;
    }
    case TerrainType::kSteps:
      ground.boxes = BoxesWithin(
          terrain, 1, (terrain.steps.count + 1) * terrain.steps.depth);
      break;
    case TerrainType::kObstacles:
      ground.reach = kSquaresToSide * terrain.obstacles.spacing;
      ground.boxes = BoxesWithin(terrain, ground.reach, ground.reach);
      break;
  }
  return ground;
}

std::string GroundText(const Terrain& terrain) {
  return terrain.type == TerrainType::kFlat
             ? "flat ground"
             : "ground that is " + PrintTerrain(terrain);
}

}  // namespace plsc
