#include "sim/imu.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/placement.h"
#include "tests/sim/terrains.h"

namespace plsc {
namespace {

double FeltDegrees(const Terrain& terrain, const Spot& spot = {}) {
  return FeltInclination(terrain, {}, {}, spot) * 180 / M_PI;
}

TEST_CASE("A core feels the slope that it lies on", "[imu]") {
  for (const double tilt : {0.0, 1.0, 2.0, 3.0, 5.0, 10.0}) {
    INFO(tilt);
    // Within what its edges sink in differently.
    CHECK(FeltDegrees(test::Slope(tilt)) == Approx(tilt).margin(1));
    // Whatever way it looks, wherever it is.
    CHECK(FeltDegrees(test::Slope(tilt), {3, -2, 2}) == Approx(tilt).margin(1));
  }
  CHECK(FeltDegrees({}) < 0.01);
}

TEST_CASE("Only a slope beyond the threshold is inclined", "[imu]") {
  const ImuOptions imu;
  CHECK(FeltInclination(test::Slope(1.5), {}, imu, {}) < imu.threshold);
  CHECK(FeltInclination(test::Slope(3.5), {}, imu, {}) > imu.threshold);
}

TEST_CASE("Without weight a core stays level", "[imu]") {
  SimulationOptions options;
  options.physics.gravity = 0;
  CHECK(FeltInclination(test::Slope(5), options, {}, {}) == 0);
}

TEST_CASE("Rough ground is felt where the core stands", "[imu]") {
  const Terrain rough = test::RoughGround(1, 0.05, 0.4);
  const double here = FeltDegrees(rough),
               there = FeltDegrees(rough, {1.3, 0.6, 0});
  CHECK(std::abs(here - there) > 0.5);
  CHECK(here == FeltDegrees(rough));
}

}  // namespace
}  // namespace plsc
