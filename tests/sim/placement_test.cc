#include "sim/placement.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/sim/bodies.h"
#include "tests/sim/terrains.h"

namespace plsc {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST_CASE("A robot rests a hair above any ground", "[placement]") {
  const Assembly assembly = Assemble(Cross());
  for (const Terrain& terrain : test::AllTerrains()) {
    for (const Spot& spot : {Spot{}, Spot{0.7, 1.9, 2.5}, Spot{-3, -4, -1}}) {
      INFO(static_cast<int>(terrain.type) << ' ' << spot.x);
      SimulationOptions options;
      options.start_height.reset();
      const Placement placement = StartOf(assembly, terrain, options, spot);
      CHECK(placement.position.x() == spot.x);
      CHECK(placement.position.y() == spot.y);
      CHECK(Gap(assembly, placement, terrain) == Approx(1e-4).epsilon(1e-6));
      const Spot found = SpotOf(placement);
      CHECK(std::cos(found.heading) ==
            Approx(std::cos(spot.heading)).margin(5e-3));
      CHECK(std::sin(found.heading) ==
            Approx(std::sin(spot.heading)).margin(5e-3));
    }
  }
}

TEST_CASE("On a slope a robot starts aligned, or level at a height",
          "[placement]") {
  const Assembly assembly = Assemble(Cross());
  const Terrain slope{TerrainType::kTilted, 0.2};
  SimulationOptions options;
  options.start_height.reset();
  const Placement resting = StartOf(assembly, slope, options, {});
  const Vector3d normal(0, -std::sin(0.2), std::cos(0.2));
  CHECK(resting.axes.col(2).isApprox(normal, 1e-12));
  CHECK(resting.axes.col(0).isApprox(Vector3d::UnitX(), 1e-12));
  options.start_height = 0.1;
  const Placement level = StartOf(assembly, slope, options, {0, 2, 0});
  CHECK(level.axes == Matrix3d::Identity());
  CHECK(level.position.isApprox(Vector3d(0, 2, 2 * std::tan(0.2) + 0.1)));
}

TEST_CASE("A robot above an obstacle is put on top of it", "[placement]") {
  Terrain stairs;
  stairs.type = TerrainType::kSteps;
  stairs.steps = {0.05, 0.3, 5};
  const Assembly core = Assemble(LoneCore());
  // Its front edge, 44.5 mm ahead, hangs over the second step.
  const Placement placement =
      SetDown(core, Matrix3d::Identity(), {0, 0.57, 0}, stairs, 0);
  CHECK(placement.position.z() == Approx(0.1 + 0.0225));
}

TEST_CASE("A core on end looks where its side tells", "[placement]") {
  Placement core;
  core.axes = Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitX()).toRotationMatrix();
  core.axes.col(1) = Vector3d::UnitZ();
  CHECK(SpotOf(core).heading == Approx(0).margin(1e-12));
}

}  // namespace
}  // namespace plsc
