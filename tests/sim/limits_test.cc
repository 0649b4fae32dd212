// A world that goes wrong, and robots and lives that are absurd: each has its
// outcome and its reason, none hangs or dies, and none harms its neighbours.

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "sim/simulate.h"
#include "tests/sanitizer.h"
#include "tests/sim/bodies.h"
#include "tests/sim/engines.h"
#include "tests/sim/terrains.h"

namespace plsc {
namespace {

SimulationOptions Second(EngineKind engine) {
  SimulationOptions options = test::With(engine);
  options.duration = 1;
  return options;
}

TEST_CASE("Lives that cannot be lived have an outcome and a reason",
          "[limits]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  struct Row {
    const char* why;
    void (*change)(SimulationOptions&);
    Outcome outcome;
    const char* reason;
  };
  const Row rows[] = {
      {"a fine life", [](SimulationOptions&) {}, Outcome::kCompleted, ""},
      {"no time", [](SimulationOptions& o) { o.duration = 0; },
       Outcome::kOutOfSteps, "0 s are no step of 0.005 s"},
      {"less than a step", [](SimulationOptions& o) { o.duration = 0.002; },
       Outcome::kOutOfSteps, "no step"},
      {"10 hours", [](SimulationOptions& o) { o.duration = 36000; },
       Outcome::kOutOfSteps,
       "36000 s are 7200000 steps of 0.005 s, more than max_steps, 1000000"},
      {"for ever",
       [](SimulationOptions& o) {
         o.duration = std::numeric_limits<double>::infinity();
       },
       Outcome::kOutOfSteps, "more than max_steps"},
      {"not a number of seconds",
       [](SimulationOptions& o) { o.duration = NAN; }, Outcome::kOutOfSteps,
       "more than max_steps"},
      {"faster than allowed",
       [](SimulationOptions& o) { o.physics.max_speed = 0.1; },
       Outcome::kUnstable, "more than max_speed, 0.1 m/s"},
      {"turns faster than allowed",
       [](SimulationOptions& o) { o.physics.max_spin = 0.01; },
       Outcome::kUnstable, "more than max_spin, 0.01 rad/s"},
      {"infinite gravity",
       [](SimulationOptions& o) {
         o.physics.gravity = std::numeric_limits<double>::infinity();
       },
       Outcome::kUnstable, ""},
      {"gravity that is no number",
       [](SimulationOptions& o) { o.physics.gravity = NAN; },
       Outcome::kUnstable, ""},
      {"gravity that overflows",
       [](SimulationOptions& o) { o.physics.gravity = 1e308; },
       Outcome::kUnstable, ""},
      {"ground like air",
       [](SimulationOptions& o) {
         o.physics.ground_kp = 1e-9;
         o.physics.ground_kd = 1e-9;
         o.physics.robot_kd = 0;
       },
       Outcome::kFellThrough, "below the ground"},
  };
  const Phenotype robot = WithOscillators(Cross(), 1, 2);
  const std::uint64_t healthy = Simulate(robot, {}, Second(engine)).state_hash;
  for (const Row& row : rows) {
    INFO(row.why);
    SimulationOptions options = Second(engine);
    row.change(options);
    const Trajectory life = Simulate(robot, {}, options);
    INFO(life.reason);
    CHECK(life.outcome == row.outcome);
    CHECK(life.reason.empty() == (row.outcome == Outcome::kCompleted));
    CHECK(life.reason.find(row.reason) != std::string::npos);
    CHECK(life.core_position.allFinite());
    // The same again, and the next robot is as if nothing had been.
    CHECK(Simulate(robot, {}, options).reason == life.reason);
    CHECK(Simulate(robot, {}, Second(engine)).state_hash == healthy);
  }
}

TEST_CASE("Worlds go wrong on every ground in the same way", "[limits]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const Phenotype robot = WithOscillators(Cross(), 1, 2);
  for (const Terrain& terrain : test::AllTerrains()) {
    INFO(static_cast<int>(terrain.type));
    SimulationOptions options = Second(engine);
    options.physics.gravity = NAN;
    CHECK(Simulate(robot, terrain, options).outcome == Outcome::kUnstable);
    options = Second(engine);
    options.duration = 2;
    options.physics.ground_kp = options.physics.ground_kd = 1e-9;
    options.physics.robot_kd = 0;
    const Trajectory life = Simulate(robot, terrain, options);
    INFO(life.reason);
    CHECK(life.outcome == Outcome::kFellThrough);
  }
}

TEST_CASE("A solver that fails too often ends the life", "[limits]") {
  // Contacts that do not slip at all over-determine the robot's place. For
  // ODE's solver alone: what the articulated engine solves has one solution for
  // any slip and friction, and no way was found to make it fail.
  const Phenotype robot = WithOscillators(Cross(), 0.5, 2);
  SimulationOptions options = Second(EngineKind::kOde);
  options.duration = 5;
  options.physics.slip = 0;
  options.physics.friction = 10;
  options.physics.max_solver_failures = 1e9;
  const Trajectory all = Simulate(robot, {}, options);
  INFO(all.solver_warnings);
  REQUIRE(all.outcome == Outcome::kCompleted);
  REQUIRE(all.solver_warnings > 10);
  options.physics.max_solver_failures = 0.002;  // 2 of 1000 steps
  const Trajectory few = Simulate(robot, {}, options);
  CHECK(few.outcome == Outcome::kSolverFailed);
  CHECK(few.reason ==
        "the solver failed 3 times, more than max_solver_failures, 0.002 of "
        "the steps");
  CHECK(few.steps < all.steps);
}

TEST_CASE("Robots of 1,000 modules and 500 joints have an outcome",
          "[limits]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const Phenotype robot = WithOscillators(Comb(500), 1, 2);
  REQUIRE(robot.body.modules.size() == 1001);
  SimulationOptions options = Second(engine);
  const Trajectory refused = Simulate(robot, {}, options);
  CHECK(refused.outcome == Outcome::kTooLarge);
  CHECK(refused.reason == "501 links, more than max_links, 256");
  CHECK(refused.time.size() == 0);
  // Who wants them gets them, at their price.
  options.max_links = 501;
  options.duration = 0.02;
  options.sample_interval = 0.01;
  const Trajectory lived = Simulate(robot, {}, options);
  INFO(lived.reason);
  CHECK(lived.outcome == Outcome::kCompleted);
  CHECK(lived.joint_angle.rows() == 500);
}

TEST_CASE("A thousand bricks are one link", "[limits]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  Body chain = LoneCore();
  int end = 0;
  for (int i = 1; i < 1000; ++i)
    end = Mount(chain, end, Slot::kFront, ModuleType::kBrick);
  SimulationOptions options = Second(engine);
  options.duration = 0.005 * test::Sampled(100);
  for (const Terrain& terrain : test::AllTerrains()) {
    options.start_height.reset();
    const Trajectory life = Simulate({chain, {}}, terrain, options);
    INFO(static_cast<int>(terrain.type) << ' ' << life.reason);
    CHECK(life.outcome == Outcome::kCompleted);
  }
}

}  // namespace
}  // namespace plsc
