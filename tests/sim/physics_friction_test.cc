// A block on a slope against Coulomb's law.

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/world.h"
#include "tests/sim/bodies.h"
#include "tests/sim/engines.h"
#include "tests/sim/terrains.h"

namespace plsc {
namespace {

using Eigen::Vector3d;

constexpr double kGravity = 9.8;  // m/s2
constexpr double kMass = 0.090;   // kg, of a core
constexpr double kSlip = 0.01;    // m/s per N

/// m/s down the slope after each of two spans of a second, of a core that was
/// set down on it.
struct Slide {
  double first = 0, second = 0;
};

Slide SlideDown(EngineKind engine, double degrees, double friction) {
  const Terrain slope = test::Slope(degrees);
  SimulationOptions options = test::With(engine);
  options.start_height.reset();  // at rest on the slope
  options.physics.gravity = kGravity;
  options.physics.friction = friction;
  options.physics.slip = kSlip;
  options.physics.damping = 0;
  World world(Assemble(LoneCore()), slope, options);
  const Vector3d downhill(0, -std::cos(slope.tilt), -std::sin(slope.tilt));
  const auto speed_after_a_second = [&] {
    for (int i = 0; i < 200; ++i) REQUIRE(world.Step());
    return world.MotionOf(0).velocity.dot(downhill);
  };
  Slide slide;
  slide.first = speed_after_a_second();
  slide.second = speed_after_a_second();
  return slide;
}

TEST_CASE("A block holds on slopes up to its friction and slides beyond",
          "[physics]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  // Friction is a pyramid with an edge up the slope, so the limit is tan(tilt)
  // there. 2 % on either side of it.
  constexpr double kMargin = 0.02;
  // What drives or holds is the small difference of forces of size m g
  // sin(tilt). Softness of contacts costs 1e-5 of that here.
  constexpr double kOfPull = 1e-4;
  for (const double degrees : {5.0, 15.0, 30.0}) {
    CAPTURE(degrees);
    const double tilt = degrees * M_PI / 180;
    const double pull = kGravity * std::sin(tilt);  // m/s2

    // a = g (sin - mu cos)
    const Slide beyond =
        SlideDown(engine, degrees, (1 - kMargin) * std::tan(tilt));
    CHECK(beyond.second - beyond.first ==
          Approx(kMargin * pull).margin(kOfPull * pull));

    // Held, but for the slip of its contacts: 4 of them share the pull. Evenly
    // though those below carry more, as ODE's friction limits are of normal
    // forces before friction acts.
    const Slide below =
        SlideDown(engine, degrees, (1 + kMargin) * std::tan(tilt));
    CHECK(below.second == Approx(kSlip * kMass * pull / 4).epsilon(1e-3));
    CHECK(std::abs(below.second - below.first) < kOfPull * pull);
  }
}

TEST_CASE("Without slip a block below its friction limit stays", "[physics]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  // m/s; 100 s of it are the thickness of a hair.
  constexpr double kStill = 1e-6;
  for (const double degrees : {5.0, 15.0, 30.0}) {
    CAPTURE(degrees);
    const double tilt = degrees * M_PI / 180;
    const Terrain slope = test::Slope(degrees);
    SimulationOptions options = test::With(engine);
    options.start_height.reset();
    options.physics.friction = 1.02 * std::tan(tilt);
    options.physics.slip = 0;
    World world(Assemble(LoneCore()), slope, options);
    for (int i = 0; i < 400; ++i) REQUIRE(world.Step());
    const Vector3d along(0, std::cos(tilt), std::sin(tilt));
    CHECK(std::abs(world.MotionOf(0).velocity.dot(along)) < kStill);
  }
}

}  // namespace
}  // namespace plsc
