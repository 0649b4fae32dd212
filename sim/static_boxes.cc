// Endless ground without a list: a box is a function of its ordinal (steps) or
// its cell (obstacles), so that whoever looks at a place asks for the boxes
// there, and each is the same each time. Obstacles stay inside of their cell,
// so only the cells under the asked bounds can have one that reaches in. Places
// may be anywhere, also where a robot explodes to, so counts are kept as
// doubles until they are known to fit an int.

#include "sim/static_boxes.h"

#include <algorithm>
#include <cmath>

#include "sim/lattice_noise.h"

namespace plsc {
namespace {

using Eigen::Vector3d;

// m, half the width and all of the length of stairs: no robot walks so far in
// a life (0.05 m/s for an hour are 180 m).
constexpr double kEndless = 1000;

/// The k-th from 1. It reaches to the end under all that follow, so that a
/// robot on a step never meets the back of the one below.
StaticBox StepBox(const Steps& steps, int k) {
  const double begin = k * steps.depth;
  const double top = k * steps.height;
  return {{0, begin + kEndless / 2, (top - kBoxDepth) / 2},
          {2 * kEndless, kEndless, top + kBoxDepth}};
}

void AppendSteps(const Steps& steps, const Eigen::AlignedBox3d& bounds,
                 std::vector<StaticBox>& boxes) {
  // As numbers that need not fit an int: robots may be anywhere.
  const double first = std::floor(bounds.min().z() / steps.height) + 1;
  const double last = std::floor(bounds.max().y() / steps.depth);
  const double count = steps.count;
  const int end = static_cast<int>(std::clamp(last, 0.0, count));
  int k = static_cast<int>(std::clamp(first, 1.0, count + 1));
  for (; k <= end; ++k) boxes.push_back(StepBox(steps, k));
}

/// In a square of the lattice; anywhere in it that leaves it inside.
StaticBox ObstacleBox(const Obstacles& obstacles, std::int64_t i,
                      std::int64_t j) {
  const auto draw = [&](std::uint64_t ordinal) {
    return LatticeNoise(obstacles.seed, i, j, ordinal);
  };
  // From half the largest to the largest.
  const double width = obstacles.size * (0.5 + 0.5 * draw(0));
  const double length = obstacles.size * (0.5 + 0.5 * draw(1));
  const double height = obstacles.height * (0.5 + 0.5 * draw(2));
  const double x = static_cast<double>(i) * obstacles.spacing + width / 2 +
                   draw(3) * (obstacles.spacing - width);
  const double y = static_cast<double>(j) * obstacles.spacing + length / 2 +
                   draw(4) * (obstacles.spacing - length);
  return {{x, y, (height - kBoxDepth) / 2},
          {width, length, height + kBoxDepth}};
}

bool IsNearOrigin(const StaticBox& box) {
  const Vector3d nearest = (box.centre.cwiseAbs() - box.size / 2).cwiseMax(0);
  return nearest.head<2>().norm() < kClearRadius;
}

void AppendObstacles(const Obstacles& obstacles,
                     const Eigen::AlignedBox3d& bounds,
                     std::vector<StaticBox>& boxes) {
  if (bounds.min().z() > obstacles.height) return;
  const auto cell = [&](double place) {
    return static_cast<std::int64_t>(std::floor(place / obstacles.spacing));
  };
  for (std::int64_t j = cell(bounds.min().y()); j <= cell(bounds.max().y());
       ++j) {
    for (std::int64_t i = cell(bounds.min().x()); i <= cell(bounds.max().x());
         ++i) {
      const StaticBox box = ObstacleBox(obstacles, i, j);
      if (IsNearOrigin(box)) continue;
      const Eigen::AlignedBox3d extent(box.centre - box.size / 2,
                                       box.centre + box.size / 2);
      if (extent.intersects(bounds)) boxes.push_back(box);
    }
  }
}

}  // namespace

void AppendStaticBoxes(const Terrain& terrain,
                       const Eigen::AlignedBox3d& bounds,
                       std::vector<StaticBox>& boxes) {
  if (terrain.type == TerrainType::kSteps)
    AppendSteps(terrain.steps, bounds, boxes);
  if (terrain.type == TerrainType::kObstacles)
    AppendObstacles(terrain.obstacles, bounds, boxes);
}

}  // namespace plsc
