#include "sim/disturbance.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "sim/controller.h"
#include "sim/imu.h"
#include "sim/simulate.h"
#include "tests/sim/bodies.h"
#include "tests/sim/engines.h"
#include "tests/sim/terrains.h"

namespace plsc {
namespace {

SimulationOptions Seconds(EngineKind engine, double duration) {
  SimulationOptions options = test::With(engine);
  options.duration = duration;
  return options;
}

Trajectory Disturbed(const Phenotype& robot, const Terrain& terrain,
                     const SimulationOptions& options,
                     const Disturbance& disturbance) {
  Onset onset;
  onset.disturbance = disturbance;
  return Live(robot, terrain, options, onset).trajectory;
}

/// A cross whose four legs end in touch sensors that its joints listen to.
Phenotype Feeler() {
  Body body = Cross();
  for (int brick = 2; brick <= 8; brick += 2)
    Mount(body, brick, Slot::kFront, ModuleType::kTouchSensor);
  Phenotype robot = WithOscillators(body, 1, 8);
  for (int sensor = 9; sensor <= 12; ++sensor) {
    robot.brain.nodes.push_back({NodeType::kInput, sensor, 0.5, 0, 0, 0});
    robot.brain.connections.push_back({sensor - 5, sensor - 9, 0.8});
  }
  return robot;
}

TEST_CASE("Errors are as many and as large as they are told", "[disturbance]") {
  constexpr int kDraws = 20000;
  int flipped = 0;
  double sum = 0, most = 0;
  for (int i = 0; i < kDraws; ++i) {
    flipped += IsFlipped({0.1, 5}, i / 4, i % 4);
    const double error = TargetError({0.2, 5}, i / 4, i % 4);
    sum += error;
    most = std::max(most, std::abs(error));
  }
  // Four standard deviations: sqrt(20000 * 0.09) flips; 0.2 / sqrt(3 * 20000).
  CHECK(flipped == Approx(2000).margin(4 * 42.4));
  CHECK(sum / kDraws == Approx(0).margin(4 * 0.2 / std::sqrt(3.0 * kDraws)));
  CHECK(most <= 0.2);
  CHECK(most > 0.199);
  CHECK(IsFlipped({1, 5}, 3, 2));
  CHECK_FALSE(IsFlipped({0, 5}, 3, 2));
  // Every update, part and seed has its own.
  const double one = TargetError({0.2, 5}, 7, 1);
  CHECK(TargetError({0.2, 5}, 7, 1) == one);
  CHECK(TargetError({0.2, 5}, 8, 1) != one);
  CHECK(TargetError({0.2, 5}, 7, 2) != one);
  CHECK(TargetError({0.2, 6}, 7, 1) != one);
}

TEST_CASE("A lift raises the start by exactly that", "[disturbance]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const Phenotype robot = WithOscillators(Cross(), 1, 2);
  Disturbance disturbance;
  disturbance.lift = 17e-6;
  for (const Terrain& terrain : test::AllTerrains())
    for (const std::optional<double> height :
         {std::optional<double>(), std::optional<double>(0.03)}) {
      SimulationOptions options = Seconds(engine, 0.1);
      options.start_height = height;
      const Trajectory plain = Disturbed(robot, terrain, options, {});
      const Trajectory lifted = Disturbed(robot, terrain, options, disturbance);
      // Exact but for where an engine counts a link's place from.
      CHECK(lifted.core_position(2, 0) - plain.core_position(2, 0) ==
            Approx(17e-6).margin(1e-16));
      CHECK(lifted.core_position.col(0).head<2>() ==
            plain.core_position.col(0).head<2>());
      CHECK(lifted.state_hash != plain.state_hash);
    }
}

TEST_CASE("A shift and a yaw are another spot, friction another ground",
          "[disturbance]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const Phenotype robot = WithOscillators(Cross(), 1, 2);
  SimulationOptions options = Seconds(engine, 0.2);
  options.start_height.reset();
  Disturbance disturbance;
  disturbance.shift_x = 0.4;
  disturbance.shift_y = 1.7;
  disturbance.yaw = 0.5;
  for (const Terrain& terrain : test::AllTerrains()) {
    const Onset there{0, {0.4, 1.7, 0.5}, nullptr};
    CHECK(Disturbed(robot, terrain, options, disturbance).state_hash ==
          Live(robot, terrain, options, there).trajectory.state_hash);
  }
  Disturbance slippery;
  slippery.friction = 0.25;
  SimulationOptions ice = options;
  ice.physics.friction *= 0.25;
  CHECK(Disturbed(robot, {}, options, slippery).state_hash ==
        Simulate(robot, {}, ice).state_hash);
}

TEST_CASE("Servos strive for targets that are off", "[disturbance]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  // As in simulate_test: in free flight a joint is where its speeds lead to.
  Body body = LoneCore();
  Mount(body, 0, Slot::kFront, ModuleType::kHorizontalJoint);
  const Phenotype robot = WithOscillators(body, 0, 8);
  SimulationOptions options = Seconds(engine, 4);
  options.physics.gravity = 0;
  options.start_height = 10;
  options.sample_interval = 0.125;
  Disturbance disturbance;
  disturbance.motor = {0.3, 11};
  const Trajectory life = Disturbed(robot, {}, options, disturbance);
  double angle = 0;
  for (int update = 0; update < 32; ++update) {
    INFO("update " << update);
    CHECK(life.joint_angle(0, update) == Approx(angle).margin(1e-3));
    const double target = TargetError(disturbance.motor, update, 0);
    angle += 0.125 * 0.9 * (target - angle);
  }
  CHECK(life.joint_angle.row(0).cwiseAbs().maxCoeff() > 0.02);
}

TEST_CASE("Sensors that err act where touch does", "[disturbance]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  SimulationOptions coupled = Seconds(engine, 2);
  coupled.controller = ControllerMode::kCoupled;
  const auto hash = [&](const SimulationOptions& options, const Noise& touch) {
    Disturbance disturbance;
    disturbance.touch = touch;
    return Disturbed(Feeler(), {}, options, disturbance).state_hash;
  };
  const std::uint64_t plain = hash(coupled, {});
  CHECK(hash(coupled, {0.2, 1}) != plain);
  CHECK(hash(coupled, {0.2, 1}) != hash(coupled, {0.2, 2}));
  CHECK(hash(coupled, {0.2, 1}) == hash(coupled, {0.2, 1}));
  // Each reading is the contrary, whatever is drawn.
  CHECK(hash(coupled, {1, 1}) == hash(coupled, {1, 2}));
  CHECK(hash(coupled, {1, 1}) != plain);
  const SimulationOptions open = Seconds(engine, 2);
  CHECK(hash(open, {0.5, 1}) == hash(open, {}));
}

TEST_CASE("A body that lives on keeps its place", "[disturbance]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const Phenotype robot = WithOscillators(Cross(), 1, 2);
  const SimulationOptions options = Seconds(engine, 0.5);
  const Lived first = Live(robot, {}, options, {});
  const auto second = [&](const Disturbance& disturbance) {
    const Onset onset{0, {}, &first.end, disturbance};
    return Live(robot, {}, options, onset).trajectory.state_hash;
  };
  Disturbance place;
  place.lift = 0.1;
  place.shift_x = 0.3;
  place.yaw = 1;
  CHECK(second(place) == second({}));
  Disturbance errors;
  errors.motor = {0.3, 1};
  CHECK(second(errors) != second({}));
}

TEST_CASE("What is felt is off by the lean, and felt where one stands",
          "[disturbance]") {
  Disturbance disturbance;
  CHECK(FeltWith(disturbance, 0.1) == 0.1);
  disturbance.lean = -0.3;
  CHECK(FeltWith(disturbance, 0.1) == Approx(0.2));
  disturbance.lean = 0.3;
  CHECK(FeltWith(disturbance, 3) == std::numbers::pi);
  disturbance.shift_x = 0.4;
  disturbance.yaw = 0.5;
  for (const Terrain& terrain : test::AllTerrains()) {
    const bool is_plane = terrain.type == TerrainType::kFlat ||
                          terrain.type == TerrainType::kTilted;
    const Spot expected = is_plane ? Spot{} : Spot{0.4, 0, 0.5};
    CHECK(FeltSpot(terrain, disturbance) == expected);
    CHECK(FeltSpot(terrain, {}) == Spot{});
  }
}

}  // namespace
}  // namespace plsc
