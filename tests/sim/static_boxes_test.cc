#include "sim/static_boxes.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace plsc {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

std::vector<StaticBox> BoxesIn(const Terrain& terrain, const Vector3d& low,
                               const Vector3d& high) {
  std::vector<StaticBox> boxes;
  AppendStaticBoxes(terrain, AlignedBox3d(low, high), boxes);
  return boxes;
}

TEST_CASE("Steps rise along y", "[static_boxes]") {
  Terrain stairs;
  stairs.type = TerrainType::kSteps;
  stairs.steps = {0.02, 0.3, 5};
  struct Row {
    const char* why;
    double y, z;
    std::vector<double> tops;
  };
  const Row rows[] = {
      {"before the first", 0.25, 0.0, {}},
      {"on the first: only what it stands in", 0.45, 0.019, {0.02}},
      {"on the first, above it", 0.45, 0.021, {}},
      {"before the third, low", 0.95, 0.001, {0.02, 0.04, 0.06}},
      {"before the third, on the second", 0.95, 0.039, {0.04, 0.06}},
      {"after the last", 9, 0.05, {0.06, 0.08, 0.1}},
      {"above the last", 9, 0.101, {}},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    const auto boxes =
        BoxesIn(stairs, {-0.1, row.y - 0.1, row.z}, {0.1, row.y, row.z + 0.05});
    std::vector<double> tops;
    for (const StaticBox& box : boxes) {
      tops.push_back(box.centre.z() + box.size.z() / 2);
      const double begin = box.centre.y() - box.size.y() / 2;
      CHECK(begin == Approx(0.3 * std::round(tops.back() / 0.02)));
    }
    REQUIRE(tops.size() == row.tops.size());
    for (std::size_t i = 0; i < tops.size(); ++i)
      CHECK(tops[i] == Approx(row.tops[i]));
  }
}

TEST_CASE("Obstacles stand in their squares, none near the origin",
          "[static_boxes]") {
  Terrain field;
  field.type = TerrainType::kObstacles;
  field.obstacles = {3, 0.2, 0.1, 0.03};
  const auto all = BoxesIn(field, {-2, -2, 0}, {1.999, 1.999, 0.1});
  // 20 x 20 squares, but those at the origin.
  CHECK(all.size() > 380);
  CHECK(all.size() < 400);
  for (const StaticBox& box : all) {
    const double top = box.centre.z() + box.size.z() / 2;
    CHECK(top > 0.0149);
    CHECK(top < 0.0301);
    for (int axis = 0; axis < 2; ++axis) {
      CHECK(box.size[axis] >= 0.05);
      CHECK(box.size[axis] <= 0.1);
      const double low = box.centre[axis] - box.size[axis] / 2;
      const double high = box.centre[axis] + box.size[axis] / 2;
      CHECK(std::floor(low / 0.2 + 1e-9) == std::floor(high / 0.2 - 1e-9));
    }
    const Vector3d nearest = (box.centre.cwiseAbs() - box.size / 2).cwiseMax(0);
    CHECK(nearest.head<2>().norm() >= kClearRadius);
  }
  CHECK(BoxesIn(field, {-2, -2, 0.031}, {2, 2, 0.1}).empty());
  // The same from wherever one looks.
  const auto some = BoxesIn(field, {0.5, 0.5, 0}, {1, 1, 0.1});
  for (const StaticBox& box : some)
    CHECK(std::any_of(all.begin(), all.end(), [&](const StaticBox& other) {
      return other.centre == box.centre && other.size == box.size;
    }));
  CHECK_FALSE(some.empty());
}

TEST_CASE("Planes have no boxes", "[static_boxes]") {
  CHECK(BoxesIn({}, {-9, -9, -9}, {9, 9, 9}).empty());
}

}  // namespace
}  // namespace plsc
