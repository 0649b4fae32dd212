// The servo's response against its difference equation, through a whole life:
// brain, schedule, servo and joint together.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/simulate.h"
#include "tests/sim/bodies.h"
#include "tests/sim/engines.h"
#include "tests/sim/free_flight.h"

namespace plsc {
namespace {

// Of the authors' servo (joint.py:59, Motor.cpp:64, PositionMotor.cpp:95).
constexpr double kGain = 0.9;         // 1/s
constexpr double kRange = 0.7853982;  // rad
constexpr double kHighest = 0.99999;  // of outputs
constexpr double kFastest = 1;        // rad/s

/// One joint with a brick, its target +45 degrees for half a period, then
/// -45: a sine so large that it is a square wave.
Phenotype Switched(double period) {
  Body body = LoneCore();
  const int joint = Mount(body, 0, Slot::kFront, ModuleType::kVerticalJoint);
  Mount(body, joint, Slot::kFront, ModuleType::kBrick);
  Phenotype robot = WithOscillators(body, 1e12, period);
  // Just before 0 turns, so that the first update is already on the plateau.
  robot.brain.nodes[0].phase_offset = -1e-6;
  return robot;
}

TEST_CASE("A servo follows a step as its gain, clamp and rate say",
          "[physics]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  struct Row {
    const char* why;
    Refresh refresh;
    double interval;  // s, between updates
    double first;     // s, the first update; braked before
  };
  const Row rows[] = {
      {"at 8 Hz", Refresh::kExact, 0.125, 0},
      {"as the authors' program: the first step after 0.125 s", Refresh::kLate,
       0.130, 0.130},
  };
  constexpr double kPeriod = 16;  // s
  for (const Row& row : rows) {
    INFO(row.why);
    SimulationOptions options = test::FreeFlight(engine);
    options.duration = 15;
    options.sample_interval = row.interval;
    options.servo.refresh = row.refresh;
    const Trajectory life = Simulate(Switched(kPeriod), {}, options);
    REQUIRE(life.outcome == Outcome::kCompleted);
    // angle(k+1) = angle(k) + T clamp(gain (target - angle(k)), -1, 1): the
    // speed is held between updates, and the motor reaches it within a step.
    double angle = 0;
    double fastest = 0;
    for (Eigen::Index i = 0; i < life.time.size(); ++i) {
      const double time = static_cast<double>(i) * row.interval;
      if (time > options.duration) break;  // the last one ends the life
      INFO("at " << time);
      // Hinge and motor are soft by world_cfm, 1e-5 m/s per N: at most 0.7e-6
      // rad here, a step is up to 5000e-6.
      CHECK(life.joint_angle(0, i) == Approx(angle).margin(2e-6));
      if (time < row.first - 1e-9) continue;
      const double phase = std::fmod(time / kPeriod + 1e-6, 1.0);
      const double target =
          (phase < 0.5 ? 1 : -1) * kRange * (2 * kHighest - 1);
      const double speed =
          std::clamp(kGain * (target - angle), -kFastest, kFastest);
      fastest = std::max(fastest, std::abs(speed));
      angle += row.interval * speed;
    }
    CHECK(fastest == kFastest);  // the clamp had its part
    CHECK(angle < -0.9 * kRange);
  }
}

TEST_CASE("Servos within their torque do what they are told", "[physics]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  SimulationOptions options = test::FreeFlight(engine);
  options.duration = 5;
  const Phenotype robot = WithOscillators(Cross(), 1, 4);
  const Trajectory able = Simulate(robot, {}, options);
  REQUIRE(able.outcome == Outcome::kCompleted);
  // ODE's damping takes a ten-thousandth of a speed of at most 1 rad/s.
  CHECK(able.servo_error_median <= 1e-4);
  options.servo.max_torque = 1e-9;
  const Trajectory weak = Simulate(robot, {}, options);
  REQUIRE(weak.outcome == Outcome::kCompleted);
  CHECK(weak.servo_error_median > 0.1);
  CHECK(weak.servo_error_worst > weak.servo_error_median);
  CHECK(weak.servo_error_worst <= 1.01);  // braked, or told 1 rad/s
}

TEST_CASE("A solver that has not converged shows", "[physics]") {
  SimulationOptions options;
  options.duration = 5;
  options.start_height.reset();
  const Phenotype robot = WithOscillators(Cross(), 1, 4);
  const double direct = Simulate(robot, {}, options).servo_error_median;
  options.physics.solver = Solver::kIterative;
  options.physics.solver_iterations = 20;
  const double hasty = Simulate(robot, {}, options).servo_error_median;
  options.physics.solver_iterations = 2000;
  const double patient = Simulate(robot, {}, options).servo_error_median;
  CAPTURE(direct, hasty, patient);
  CHECK(hasty > 5 * direct);
  CHECK(hasty > 5 * patient);
}

TEST_CASE("A robot without joints has no errors", "[physics]") {
  const EngineKind engine = test::EachEngine();
  SimulationOptions options = test::With(engine);
  options.duration = 1;
  const Trajectory life = Simulate({LoneCore(), {}}, {}, options);
  REQUIRE(life.outcome == Outcome::kCompleted);
  CHECK(life.servo_error_median == 0);
  CHECK(life.servo_error_worst == 0);
}

}  // namespace
}  // namespace plsc
