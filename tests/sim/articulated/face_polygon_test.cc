#include "sim/articulated/face_polygon.h"

#include <catch2/catch.hpp>
#include <set>
#include <utility>
#include <vector>

namespace plsc {
namespace {

FacePolygon PolygonOf(const std::vector<FacePoint>& points) {
  FacePolygon polygon;
  polygon.count = 0;
  for (const FacePoint& point : points) polygon.Add(point);
  return polygon;
}

/// Corners of 2 m, as deep as their x; edge 0 leads from the first to the
/// second.
FacePolygon Square() {
  return PolygonOf({{{1, 1}, 1, 0, 0},
                    {{-1, 1}, -1, 1, 1},
                    {{-1, -1}, -1, 2, 2},
                    {{1, -1}, 1, 3, 3}});
}

std::set<int> FeaturesOf(const FacePolygon& polygon, std::size_t count) {
  std::set<int> features;
  for (std::size_t i = 0; i < count; ++i)
    features.insert(polygon.points.at(i).feature);
  return features;
}

TEST_CASE("A cut keeps what is within a side", "[face_polygon]") {
  FacePolygon rest;
  CHECK_FALSE(Cut(Square(), {0, 1}, rest));
  // By rounding out of it.
  CHECK_FALSE(Cut(Square(), {0, 1 - 1e-13}, rest));

  REQUIRE(Cut(Square(), {0, 0.5}, rest));
  // Edges 0 and 2 cross side 0.
  CHECK(FeaturesOf(rest, rest.count) == std::set<int>{4, 1, 2, 4 + 4 * 2});
  for (std::size_t i = 0; i < rest.count; ++i) {
    const FacePoint& point = rest.points.at(i);
    CHECK(point.depth == point.place[0]);
    CHECK(point.place[0] == (point.feature < 4 ? -1 : 0.5));
  }

  FacePolygon corner;
  REQUIRE(Cut(rest, {2, 0.25}, corner));
  // The corner of both sides, and where edge 1 crosses the second.
  CHECK(FeaturesOf(corner, corner.count) ==
        std::set<int>{20, 2, 4 + 4 + 2, 4 + 4 * 2});

  REQUIRE(Cut(Square(), {1, -2}, rest));
  CHECK(rest.count == 0);
}

TEST_CASE("A support is the deepest point and what spans most",
          "[face_polygon]") {
  const auto at = [](double x, double y, int feature, double depth = 0) {
    return FacePoint{{x, y}, depth, feature, 0};
  };
  struct Row {
    const char* why;
    std::vector<FacePoint> points;
    int deepest;
    std::set<int> kept;
  };
  const Row rows[] = {
      {"one", {at(0, 0, 7)}, 7, {7}},
      {"four are all kept, even in line",
       {at(0, 0, 0), at(1, 0, 1), at(2, 0, 2, 0.1), at(3, 0, 3)},
       2,
       {0, 1, 2, 3}},
      {"in line: the deepest and the farthest from it",
       {at(0, 0, 0), at(1, 0, 1, 0.1), at(2, 0, 2), at(3, 0, 3), at(4, 0, 4)},
       1,
       {1, 4}},
      {"a triangle with points on its sides",
       {at(0, 0, 0, 0.1), at(2, 0, 1), at(4, 0, 2), at(2, 1.5, 3), at(0, 3, 4),
        at(0, 1, 5)},
       0,
       {0, 2, 4}},
      {"a square with a corner cut off",
       {at(0, 0, 0, 0.1), at(1, 0, 1), at(1, 0.9, 2), at(0.8, 1, 3),
        at(0, 1, 4)},
       0,
       {0, 1, 2, 4}},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    FacePolygon polygon = PolygonOf(row.points);
    const std::size_t count = KeepSupport(polygon);
    CHECK(polygon.points[0].feature == row.deepest);
    CHECK(FeaturesOf(polygon, count) == row.kept);
  }
}

TEST_CASE("Of equally deep points the first is kept, whatever rounding says",
          "[face_polygon]") {
  FacePolygon polygon = Square();
  for (std::size_t i = 0; i < 4; ++i)
    polygon.points.at(i).depth = 0.01 + 1e-14 * static_cast<double>(i);
  KeepSupport(polygon);
  CHECK(polygon.points[0].feature == 0);
}

}  // namespace
}  // namespace plsc
