// Free fall against its formula.

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/sim/bodies.h"
#include "tests/sim/engines.h"
#include "tests/sim/free_flight.h"

namespace plsc {
namespace {

// All steps are additions of the same numbers: 400 of them lose 400 roundings
// of 1e-16, relative to a height of 100 m.
constexpr double kRounding = 1e-12;

TEST_CASE("All links fall by the sum of their steps", "[physics]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  struct Row {
    const char* why;
    Body body;
    double step;  // s
  };
  const Row rows[] = {
      {"a core", LoneCore(), 0.005},
      {"a core at the fast step", LoneCore(), 0.010},
      {"joints between falling links carry nothing", Cross(), 0.005},
  };
  constexpr int kSteps = 400;
  for (const Row& row : rows) {
    INFO(row.why);
    SimulationOptions options = test::FreeFlight(engine);
    options.physics.gravity = 9.8;
    options.physics.step = row.step;
    World world(Assemble(row.body), {}, options);
    const double start = world.MassCentre().z();
    for (int i = 0; i < kSteps; ++i) REQUIRE(world.Step());
    // Semi-implicit Euler: v(n) = -g h n acts through the n-th step, so that
    // z(n) = z(0) - g h^2 n (n + 1) / 2; h/2 v(n) more than g t^2 / 2.
    const double speed = 9.8 * row.step * kSteps;
    const double fall = 9.8 * row.step * row.step * kSteps * (kSteps + 1) / 2.0;
    CHECK(start - world.MassCentre().z() ==
          Approx(fall).epsilon(0).margin(100 * kRounding));
    for (int link = 0; link < world.links(); ++link) {
      const LinkMotion motion = world.MotionOf(link);
      CHECK(-motion.velocity.z() == Approx(speed).epsilon(kRounding));
      CHECK(std::hypot(motion.velocity.x(), motion.velocity.y()) < kRounding);
      CHECK(motion.spin.norm() < kRounding);
    }
  }
}

}  // namespace
}  // namespace plsc
