#include "runtime/pictures/map_view.h"
#include "tests/runtime/pictures/count.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("a map has its centre in the middle and +y up", "[map_view]") {
  const MapView view{{1, 2}, 100, {10, 20}, 380};
  CHECK(view({1, 2}) == Eigen::Vector2d(200, 210));
  CHECK(view({2, 3}) == Eigen::Vector2d(300, 110));
}

TEST_CASE("round lengths are as long as they fit", "[map_view]") {
  CHECK(RoundLength(100, 100) == Approx(1));
  CHECK(RoundLength(99, 100) == Approx(0.5));
  CHECK(RoundLength(49, 100) == Approx(0.2));
  CHECK(RoundLength(1999, 100) == Approx(10));
  CHECK(RoundLength(2000, 100) == Approx(20));
}

TEST_CASE("the ground is drawn as far as it can be seen", "[map_view]") {
  Terrain terrain;
  const MapView view{{0, 0}, 400, {0, 0}, 380};  // 0.95 m wide
  CHECK(GroundSvg(terrain, view).empty());
  terrain.type = TerrainType::kSteps;
  terrain.steps = {0.01, 0.2, 100};  // at 0.2 and 0.4 m
  CHECK(test::Count(GroundSvg(terrain, view), "<rect") == 2);
  terrain.type = TerrainType::kRough;
  CHECK(test::Count(GroundSvg(terrain, view), "<rect") == 19 * 19);
  terrain.type = TerrainType::kObstacles;
  const std::size_t boxes = test::Count(GroundSvg(terrain, view), "<rect");
  CHECK(boxes > 0);
  CHECK(boxes <= 25);  // squares of 0.3 m, and those that reach in

  // From far away they would be a million: none is drawn.
  const MapView far{{0, 0}, 1, {0, 0}, 380};
  for (const TerrainType type :
       {TerrainType::kSteps, TerrainType::kRough, TerrainType::kObstacles}) {
    terrain.type = type;
    CHECK(GroundSvg(terrain, far).empty());
  }
}

}  // namespace
}  // namespace plsc
