#include "sim/servo_errors.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "sim/simulate.h"
#include "tests/sim/bodies.h"
#include "tests/sim/engines.h"
#include "tests/sim/free_flight.h"

namespace plsc {
namespace {

TEST_CASE("Without errors there is no error", "[servo_errors]") {
  ServoErrors errors;
  CHECK(errors.Median() == 0);
  CHECK(errors.worst() == 0);
  errors.Add(0);
  CHECK(errors.Median() == 0);
}

TEST_CASE("The median is that of sorted sizes, to the width of a bin",
          "[servo_errors]") {
  std::mt19937 random(17);
  for (const int count : {1, 2, 3, 10, 1001}) {
    ServoErrors errors;
    std::vector<double> sizes;
    for (int i = 0; i < count; ++i) {
      const double part = static_cast<double>(random()) / 4294967296.0;
      const double error = std::pow(10, 9 * part - 7);
      errors.Add(i % 2 == 0 ? error : -error);
      sizes.push_back(error);
    }
    std::sort(sizes.begin(), sizes.end());
    const auto middle = static_cast<std::size_t>((count - 1) / 2);
    CAPTURE(count, sizes[middle]);
    CHECK(errors.Median() == Approx(sizes[middle]).epsilon(0.0157));
    CHECK(errors.worst() == sizes.back());
  }
}

TEST_CASE("What is beyond all bins is in the first or the last",
          "[servo_errors]") {
  ServoErrors errors;
  for (int i = 0; i < 3; ++i) errors.Add(1e-10);
  CHECK(errors.Median() == 0);
  for (int i = 0; i < 4; ++i) errors.Add(-1e9);
  CHECK(errors.Median() == Approx(1024).epsilon(0.02));
  CHECK(errors.worst() == 1e9);
}

TEST_CASE("Servos within their torque do what they are told",
          "[servo_errors]") {
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

TEST_CASE("A solver that has not converged shows", "[servo_errors]") {
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

TEST_CASE("A robot without joints has no errors", "[servo_errors]") {
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
