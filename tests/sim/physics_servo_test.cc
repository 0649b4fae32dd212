// The servo's response against its difference equation, through a whole life:
// brain, schedule, servo and joint together; and what servos spend against what
// links gain.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

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

// In free flight all of a robot's motion comes from its servos.

/// J, of all links.
double MotionEnergy(const Assembly& assembly, const World& world) {
  double sum = 0;
  for (int i = 0; i < world.links(); ++i) {
    const LinkMotion motion = world.MotionOf(i);
    sum +=
        assembly.links[static_cast<std::size_t>(i)].mass *
            motion.velocity.squaredNorm() / 2 +
        motion.spin.dot(test::InertiaOf(assembly, world, i) * motion.spin) / 2;
  }
  return sum;
}

TEST_CASE("Servos' work becomes motion", "[physics]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  Body body = LoneCore();
  const int joint = Mount(body, 0, Slot::kFront, ModuleType::kVerticalJoint);
  Mount(body, joint, Slot::kFront, ModuleType::kBrick);
  Mount(body, 0, Slot::kLeft, ModuleType::kHorizontalJoint);
  const Assembly assembly = Assemble(body);
  // Able to do it in a step, and to take several.
  for (const double most : {10.0, 0.002}) {
    CAPTURE(most);
    SimulationOptions options = test::FreeFlight(engine);
    options.servo.max_torque = most;
    World world(assembly, {}, options);
    world.SetJointSpeed(0, 1);
    world.SetJointSpeed(1, -0.5);
    std::vector<double> before(2, 0), speeds(2, 0), torques(2, 0);
    double work = 0;
    for (int step = 0; step < 5; ++step) {
      REQUIRE(world.Step());
      world.TellJointSpeeds(speeds);
      world.TellJointTorques(torques);
      for (std::size_t i = 0; i < 2; ++i) {
        CHECK(std::abs(torques[i]) <= most * (1 + 1e-9));
        work += torques[i] * (before[i] + speeds[i]) / 2 * options.physics.step;
      }
      before = speeds;
    }
    const double motion = MotionEnergy(assembly, world);
    CHECK(motion > 1e-6);
    CHECK(work == Approx(motion).epsilon(0.01));
  }
}

TEST_CASE("Energy is counted over a life, braking like driving", "[physics]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  SimulationOptions options = test::With(engine);
  options.duration = 2;
  options.start_height.reset();
  const Phenotype robot = WithOscillators(Cross(), 1, 1);
  const Trajectory life = Simulate(robot, {}, options);
  REQUIRE(life.outcome == Outcome::kCompleted);
  CHECK(life.weight == Approx(World(Assemble(robot.body), {}, options).Mass() *
                              options.physics.gravity));
  // At most all servos at their torque and speed all the time.
  const auto joints = static_cast<double>(life.joint_angle.rows());
  CHECK(life.energy > 0.01);
  CHECK(life.energy <
        joints * options.servo.max_torque * 10 * options.duration);
  // Twice the life from rest to rest costs about twice of it.
  options.duration = 4;
  const double twice = Simulate(robot, {}, options).energy;
  CHECK(twice == Approx(2 * life.energy).epsilon(0.25));
  // Nobody turns, nobody works.
  const Phenotype still = WithOscillators(LoneCore(), 1, 1);
  CHECK(Simulate(still, {}, options).energy == 0);
}

TEST_CASE("Both engines count nearly the same work", "[physics]") {
  SimulationOptions options = test::With(EngineKind::kOde);
  options.duration = 5;
  options.start_height.reset();
  const Phenotype robot = WithOscillators(Cross(), 1, 2);
  const double ode = Simulate(robot, {}, options).energy;
  options.physics.engine = EngineKind::kArticulated;
  CHECK(Simulate(robot, {}, options).energy == Approx(ode).epsilon(0.05));
}

}  // namespace
}  // namespace plsc
