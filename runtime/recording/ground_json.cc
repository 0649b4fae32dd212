// Relief for pages that must not need our noise functions: numbers around the
// robot's path, no farther than the eye goes. Grids are as fine as the ground's
// wavelength asks for and no finer than kMaxHeights allows, boxes are cut to
// the extent, and what would be too many is shown in part: a picture may be
// coarse, a file of a gigabyte may not be.

#include "runtime/recording/ground_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "runtime/recording/track.h"
#include "sim/height_field.h"
#include "sim/static_boxes.h"

namespace plsc {

namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Json = nlohmann::ordered_json;

// m, of heights and of boxes: a tenth of a millimetre is a pixel of a picture
// of 1 m on 10000.
constexpr double kHeightUnit = 1e-4;
// Points to a wavelength: straight lines between them are off by 2 % of the
// amplitude.
constexpr double kPointsToWave = 8;
// Above any step or obstacle, m; below the plane boxes go on.
constexpr double kAbove = 1e4;

Json HeightsJson(const Rough& rough, const AlignedBox2d& extent) {
  const Vector2d size = extent.sizes();
  // A coarse picture of ground that is too fine to be shown.
  const double spacing =
      std::max(rough.wavelength / kPointsToWave,
               1.1 * std::sqrt(size.x() * size.y() / kMaxHeights));
  const auto count = [&](double length) {
    return static_cast<Eigen::Index>(std::ceil(length / spacing)) + 1;
  };
  const HeightField field(rough);
  Eigen::MatrixXd heights(count(size.y()), count(size.x()));
  for (Eigen::Index row = 0; row < heights.rows(); ++row)
    for (Eigen::Index column = 0; column < heights.cols(); ++column)
      heights(row, column) =
          field
              .At(extent.min().x() + spacing * static_cast<double>(column),
                  extent.min().y() + spacing * static_cast<double>(row))
              .height;
  return {{"x", extent.min().x()},
          {"y", extent.min().y()},
          {"spacing", spacing},
          {"unit", kHeightUnit},
          {"columns", heights.cols()},
          {"rows", heights.rows()},
          {"data", EncodeTrack(heights, kHeightUnit)}};
}

/// Smaller, about its centre, if obstacles stand so close that there would be
/// too many.
AlignedBox2d Manageable(const Terrain& terrain, const AlignedBox2d& extent) {
  if (terrain.type != TerrainType::kObstacles) return extent;
  const double spacing = terrain.obstacles.spacing;
  // Those at the border reach in.
  const double most = std::sqrt(kMaxBoxes) * spacing - 2 * spacing;
  const Vector2d half = extent.sizes().cwiseMin(most) / 2;
  return {extent.center() - half, extent.center() + half};
}

Json BoxesJson(const Terrain& terrain, const AlignedBox2d& extent) {
  Eigen::AlignedBox3d bounds;
  bounds.extend(Eigen::Vector3d(extent.min().x(), extent.min().y(), -1));
  bounds.extend(Eigen::Vector3d(extent.max().x(), extent.max().y(), kAbove));
  std::vector<StaticBox> boxes;
  AppendStaticBoxes(terrain, bounds, boxes);
  // Stairs have as many boxes as steps: the lowest are those one sees.
  if (boxes.size() > kMaxBoxes) boxes.resize(kMaxBoxes);
  Eigen::MatrixXd numbers(5, static_cast<Eigen::Index>(boxes.size()));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const StaticBox& box = boxes[i];
    // Stairs go on for a kilometre, which nobody sees.
    const Vector2d low =
        (box.centre - box.size / 2).head<2>().cwiseMax(extent.min());
    const Vector2d high =
        (box.centre + box.size / 2).head<2>().cwiseMin(extent.max());
    const Vector2d centre = (low + high) / 2;
    const Vector2d size = (high - low).cwiseMax(0);
    numbers.col(static_cast<Eigen::Index>(i)) << centre.x(), centre.y(),
        size.x(), size.y(), box.centre.z() + box.size.z() / 2;
  }
  return {{"unit", kHeightUnit},
          {"rows", numbers.rows()},
          {"samples", numbers.cols()},
          {"data", EncodeTrack(numbers, kHeightUnit)}};
}

}  // namespace

AlignedBox2d GroundExtent(const RecordedSeason& season) {
  AlignedBox2d extent(Vector2d(0, 0));
  const Eigen::MatrixXd& position = season.motion.position;
  const bool has_moved = season.motion.samples() > 0 && position.rows() > 0;
  if (has_moved) {
    const Vector2d start = position.col(0).head<2>();
    const Vector2d far = Vector2d::Constant(kFarthestGround);
    extent = AlignedBox2d(start);
    for (Eigen::Index row = 0; row + 2 < position.rows(); row += 3)
      for (Eigen::Index i = 0; i < position.cols(); ++i)
        extent.extend(Vector2d(position(row, i), position(row + 1, i))
                          .cwiseMax(start - far)
                          .cwiseMin(start + far)
                          .eval());
  }
  const Vector2d margin = Vector2d::Constant(kGroundMargin);
  return {extent.min() - margin, extent.max() + margin};
}

std::string GroundJson(const RecordedSeason& season) {
  const AlignedBox2d extent = GroundExtent(season);
  Json json = Json::object();
  switch (season.terrain.type) {
    case TerrainType::kFlat:
    case TerrainType::kTilted:
      break;
    case TerrainType::kRough:
      json["heights"] = HeightsJson(season.terrain.rough, extent);
      break;
    case TerrainType::kSteps:
    case TerrainType::kObstacles:
      json["boxes"] =
          BoxesJson(season.terrain, Manageable(season.terrain, extent));
      break;
  }
  return json.dump();
}

}  // namespace plsc
