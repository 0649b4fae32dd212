#include "runtime/exports/exported_ground.h"

#include <catch2/catch.hpp>

#include "sim/height_field.h"

namespace plsc {
namespace {

Terrain Of(TerrainType type) {
  Terrain terrain;
  terrain.type = type;
  return terrain;
}

TEST_CASE("Planes have no relief", "[exported_ground]") {
  Terrain hill = Of(TerrainType::kTilted);
  hill.tilt = 0.1;
  for (const Terrain& terrain : {Terrain{}, hill}) {
    const ExportedGround ground = GroundOf(terrain);
    CHECK(ground.reach == 0);
    CHECK(ground.heights.size() == 0);
    CHECK(ground.boxes.empty());
    CHECK(ground.lowest() == 0);
    CHECK(ground.highest() == 0);
  }
}

TEST_CASE("Rough ground is a grid of its heights", "[exported_ground]") {
  const Terrain terrain = Of(TerrainType::kRough);
  const ExportedGround ground = GroundOf(terrain);
  CHECK(ground.reach == Approx(5));
  const HeightField field(terrain.rough);
  const Eigen::Index last = ground.heights.rows() - 1;
  REQUIRE(ground.heights.cols() == last + 1);
  CHECK(ground.heights(last / 2, last / 2) == 0);
  const double spacing = 2 * ground.reach / static_cast<double>(last);
  for (const Eigen::Index i : {Eigen::Index{0}, Eigen::Index{17}, last})
    CHECK(ground.heights(i, 3) ==
          Approx(field
                     .At(-ground.reach + 3 * spacing,
                         -ground.reach + static_cast<double>(i) * spacing)
                     .height)
              .margin(1e-12));
  CHECK(ground.lowest() < 0);
  CHECK(ground.highest() > 0);
}

TEST_CASE("Stairs are boxes, all of them", "[exported_ground]") {
  Terrain stairs = Of(TerrainType::kSteps);
  for (const int count : {1, 20, 1000}) {
    stairs.steps.count = count;
    const ExportedGround ground = GroundOf(stairs);
    REQUIRE(ground.boxes.size() == static_cast<std::size_t>(count));
    const StaticBox& top = ground.boxes.back();
    CHECK(top.centre.z() + top.size.z() / 2 ==
          Approx(count * stairs.steps.height));
    CHECK(top.centre.y() - top.size.y() / 2 ==
          Approx(count * stairs.steps.depth));
  }
}

TEST_CASE("Obstacles are the boxes around the start", "[exported_ground]") {
  Terrain stones = Of(TerrainType::kObstacles);
  for (const double spacing : {0.02, 0.3, 50.0}) {
    stones.obstacles.spacing = spacing;
    stones.obstacles.size = std::min(0.1, spacing);
    const ExportedGround ground = GroundOf(stones);
    CHECK(ground.boxes.size() > 1900);
    CHECK(ground.boxes.size() <= 2500);
    for (const StaticBox& box : ground.boxes) {
      CHECK(std::abs(box.centre.x()) < ground.reach + spacing);
      CHECK(std::abs(box.centre.y()) < ground.reach + spacing);
    }
  }
}

TEST_CASE("Ground is told as scenarios say it", "[exported_ground]") {
  CHECK(GroundText({}) == "flat ground");
  Terrain hill = Of(TerrainType::kTilted);
  hill.tilt = 0.08726646259971647;
  CHECK(GroundText(hill) == "ground that is {tilted: 5 deg}");
}

}  // namespace
}  // namespace plsc
