#include "sim/controller.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/sim/bodies.h"

namespace plsc {
namespace {

/// A joint (module 1) in front, a sensor (module 2) at the right.
Phenotype JointAndSensor() {
  Body body = LoneCore();
  Mount(body, 0, Slot::kFront, ModuleType::kHorizontalJoint);
  Mount(body, 0, Slot::kRight, ModuleType::kTouchSensor);
  Phenotype robot = WithOscillators(body, 1, 4);
  robot.brain.nodes.push_back({NodeType::kInput, 2, 0.5, 0, 0, 0});
  return robot;
}

TEST_CASE("Oscillate is Eq. 1", "[controller]") {
  struct Row {
    const char* why;
    double amplitude, period, phase_offset, time, output;
  };
  const Row rows[] = {
      {"starts in the middle", 1, 4, 0, 0, 0.5},
      {"crest after a quarter", 1, 4, 0, 1, 1},
      {"trough after three", 1, 4, 0, 3, 0},
      {"an offset of a quarter starts in the trough", 1, 4, 0.25, 0, 0},
      {"whole offsets do not act", 1, 4, 7, 1, 1},
      {"amplitude is not clamped", 10, 4, 0, 1, 5.5},
      {"sin(60 degrees)", 2, 6, 0, 1, 0.5 + std::sqrt(3) / 2},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    const Node node{NodeType::kOscillator, 1,          0,
                    row.amplitude,         row.period, row.phase_offset};
    CHECK(Oscillate(node, row.time) == Approx(row.output).margin(1e-12));
  }
}

TEST_CASE("The servo strives for its target, never fast", "[controller]") {
  const ServoOptions servo;
  struct Row {
    const char* why;
    double output, angle, speed;
  };
  const Row rows[] = {
      {"at rest", 0.5, 0, 0},
      {"0.9 per radian of error", 0.5, -0.2, 0.18},
      {"and back", 0.5, 0.2, -0.18},
      {"to the upper limit", 1, 0, 0.9 * 0.7853982},
      {"beyond 1 is the upper limit", 5.5, 0, 0.9 * 0.7853982},
      {"below 0 the lower", -4, 0, -0.9 * 0.7853982},
      {"at most 1 rad/s", 1, -0.7853982, 1},
      {"at most -1 rad/s", 0, 0.7853982, -1},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    // Outputs end 1e-5 before the limits: 1.6e-5 rad.
    CHECK(ServoSpeed(row.output, row.angle, servo) ==
          Approx(row.speed).margin(2e-5));
  }
}

TEST_CASE("Outputs come in the order of joints", "[controller]") {
  Body body = LoneCore();
  const int first = Mount(body, 0, Slot::kFront, ModuleType::kHorizontalJoint);
  Mount(body, 0, Slot::kLeft, ModuleType::kBrick);
  const int second = Mount(body, 0, Slot::kRight, ModuleType::kVerticalJoint);
  Mount(body, 0, Slot::kBack, ModuleType::kVerticalJoint);
  Phenotype robot{body, {}};
  // Listed the other way round; the third joint has none.
  robot.brain.nodes = {{NodeType::kOscillator, second, 0, 1, 4, 0},
                       {NodeType::kOscillator, first, 0, 1, 4, 0.5}};
  Controller controller(robot, ControllerMode::kOpenLoop);
  const auto outputs =
      controller.Update(1, std::vector<bool>(body.modules.size()));
  REQUIRE(outputs.size() == 3);
  CHECK(outputs[0] == Approx(0).margin(1e-12));
  CHECK(outputs[1] == Approx(1));
  CHECK(outputs[2] == 0.5);
}

TEST_CASE("Edges act only if coupled", "[controller]") {
  Phenotype robot = JointAndSensor();
  robot.brain.connections = {{1, 0, 0.25}, {0, 0, -0.5}};
  const std::vector<bool> free(3), touched{false, false, true};
  SECTION("open loop: the oscillator alone") {
    Controller controller(robot, ControllerMode::kOpenLoop);
    CHECK(controller.Update(0, touched)[0] == Approx(0.5));
    CHECK(controller.Update(0.5, touched)[0] == Approx(0.5 + std::sqrt(2) / 4));
  }
  SECTION("coupled: touch adds its weight, the loop its last output") {
    Controller controller(robot, ControllerMode::kCoupled);
    // The loop's first previous output is the middle: nothing.
    CHECK(controller.Update(0, touched)[0] == Approx(0.75));
    // 0.5 - 0.5 * (0.75 - 0.5)
    CHECK(controller.Update(0, free)[0] == Approx(0.375));
    // Crest: 1 - 0.5 * (0.375 - 0.5), clamped
    CHECK(controller.Update(1, free)[0] == 1);
  }
}

}  // namespace
}  // namespace plsc
