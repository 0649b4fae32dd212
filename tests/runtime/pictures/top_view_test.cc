#include "runtime/pictures/top_view.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/runtime/recording/recorded.h"

namespace plsc {
namespace {

using Points = std::vector<Eigen::Vector2d>;

double Area(const Points& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

TEST_CASE("a hull goes around its points", "[top_view]") {
  struct Row {
    const char* why;
    Points points;
    std::size_t corners;
    double area;
  };
  const std::vector<Row> rows = {
      {"none", {}, 0, 0},
      {"a square and its middle",
       {{0, 0}, {1, 1}, {1, 0}, {0.5, 0.5}, {0, 1}},
       4,
       1},
      {"points on an edge", {{0, 0}, {1, 0}, {2, 0}, {2, 2}}, 3, 2},
      {"each twice", {{0, 0}, {0, 0}, {1, 0}, {1, 0}, {0, 1}, {0, 1}}, 3, 0.5},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const Points hull = ConvexHull(row.points);
      CHECK(hull.size() == row.corners);
      CHECK(Area(hull) == Approx(row.area));
    }
  }
}

// A core of 89, 89, 45 mm at the origin, turned as told.
RecordedSeason TurnedCore(const Eigen::Vector4d& turn) {
  RecordedSeason season;
  season.body = RecordBody(LoneCore());
  season.motion.steps = {0};
  season.motion.position = Eigen::Vector3d(1, 2, 3);
  season.motion.turn = turn;
  return season;
}

TEST_CASE("a box casts the shadow of its pose", "[top_view]") {
  struct Row {
    const char* why;
    Eigen::Vector4d turn;
    double area;
  };
  const double half = std::sqrt(0.5);
  // cos and sin of pi/8: a turn by 45 degrees.
  const double c = std::cos(M_PI / 8);
  const double s = std::sin(M_PI / 8);
  const std::vector<Row> rows = {
      {"upright", {1, 0, 0, 0}, 0.089 * 0.089},
      {"turned about the vertical", {c, 0, 0, s}, 0.089 * 0.089},
      {"on its side", {half, half, 0, 0}, 0.089 * 0.045},
      {"on an edge: 89 mm times (89 + 45) mm / sqrt 2",
       {c, s, 0, 0},
       0.089 * (0.089 + 0.045) * half},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const auto outlines = TopView(TurnedCore(row.turn), 0);
      REQUIRE(outlines.size() == 1);
      CHECK(Area(outlines[0].corners) == Approx(row.area));
      Eigen::Vector2d mean(0, 0);
      for (const auto& corner : outlines[0].corners) mean += corner;
      mean /= static_cast<double>(outlines[0].corners.size());
      CHECK(mean.isApprox(Eigen::Vector2d(1, 2), 1e-9));
    }
  }
}

TEST_CASE("what is higher is drawn later", "[top_view]") {
  const RecordedSeason season = test::LiveRecorded(test::SmallRobot(), {}, 0.1);
  const auto outlines = TopView(season, 0);
  // Core, frame and sensor; servo, plate and brick.
  REQUIRE(outlines.size() == 6);
  // At rest no box is higher than the core's centre but rounding; without
  // samples the rest pose is shown.
  RecordedSeason rest = season;
  rest.motion = {};
  CHECK(TopView(rest, 0).size() == 6);
}

}  // namespace
}  // namespace plsc
