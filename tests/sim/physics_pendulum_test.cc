// A physical pendulum against its formula: a rod that hangs by its end in a
// block of a ton, its motor switched off.

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <vector>

#include "sim/world.h"
#include "tests/sim/engines.h"

namespace plsc {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kPendulumGravity = 9.8;  // m/s2
constexpr double kLength = 0.1;           // m, hinge to the rod's middle

Link SolidBox(double mass, const Vector3d& size, const Vector3d& centre,
              const Matrix3d& axes) {
  const Vector3d squares = size.cwiseAbs2();
  const Vector3d moments =
      mass / 12 * (Vector3d::Constant(squares.sum()) - squares);
  Link link;
  link.mass = mass;
  link.centre = centre;
  link.inertia = axes * moments.asDiagonal() * axes.transpose();
  link.boxes = {{0, Part::kCore, mass, size, centre, axes}};
  return link;
}

/// With the rod `amplitude` from the vertical when its joint is at 0. The rod
/// swings in the block: links that share a hinge do not collide.
Assembly Pendulum(double amplitude) {
  const Vector3d down(std::sin(amplitude), 0, -std::cos(amplitude));
  Matrix3d axes;  // third column along the rod
  axes << Vector3d::UnitY().cross(-down), Vector3d::UnitY(), -down;
  Assembly pendulum;
  // 10,000 times the rod's mass: moves by 1e-4 of what the rod does.
  pendulum.links.push_back(
      SolidBox(1000, {1, 1, 1}, Vector3d::Zero(), Matrix3d::Identity()));
  pendulum.links.push_back(
      SolidBox(0.1, {0.02, 0.02, 0.2}, kLength * down, axes));
  pendulum.hinges = {{0, 0, 1, Vector3d::Zero(), Vector3d::UnitY()}};
  return pendulum;
}

SimulationOptions Swinging(EngineKind engine, double step) {
  SimulationOptions options = test::With(engine);
  options.start_height = 0.5;  // the block stands on the ground
  options.physics.gravity = kPendulumGravity;
  options.physics.damping = 0;
  options.physics.step = step;
  options.servo.max_torque = 0;  // no motor
  options.servo.range = 3;       // rad; no stop within the swing
  return options;
}

/// s, of the lowest point's n-th passing in one direction; linear in the step.
std::vector<double> Passings(World& world, double lowest, double step,
                             int count) {
  std::vector<double> times;
  double before = world.JointAngle(0) - lowest;
  for (int i = 1; static_cast<int>(times.size()) < count; ++i) {
    REQUIRE(world.Step());
    const double now = world.JointAngle(0) - lowest;
    if (before < 0 && now >= 0)
      times.push_back(step * (i - now / (now - before)));
    before = now;
  }
  return times;
}

TEST_CASE("A pendulum swings with the period of its length", "[physics]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  struct Row {
    double amplitude;  // rad
    double step;       // s
  };
  for (const Row& row : {Row{0.05, 0.005}, Row{0.05, 0.001}, Row{0.5, 0.005},
                         Row{0.5, 0.001}, Row{1.0, 0.001}}) {
    CAPTURE(row.amplitude, row.step);
    const Assembly pendulum = Pendulum(row.amplitude);
    const Link& rod = pendulum.links[1];
    const double about_hinge = rod.inertia(1, 1) + rod.mass * kLength * kLength;
    // T = 2 pi sqrt(I / (m g l)) (1 + a^2/16 + 11 a^4/3072 + ...); the next
    // term, 173 a^6/737280, is 2.4e-4 at 1 rad.
    const double a = row.amplitude;
    const double expected =
        2 * M_PI *
        std::sqrt(about_hinge / (rod.mass * kPendulumGravity * kLength)) *
        (1 + a * a / 16 + 11 * std::pow(a, 4) / 3072 +
         173 * std::pow(a, 6) / 737280);
    World world(pendulum, {}, Swinging(engine, row.step));
    // Positive angles turn the rod towards -x; it starts at +x or -x of the
    // lowest point by the sign of its angle there.
    const double lowest = row.amplitude;
    constexpr int kPeriods = 5;
    const auto times = Passings(world, lowest, row.step, kPeriods + 1);
    const double period = (times.back() - times.front()) / kPeriods;
    // Semi-implicit Euler shortens it by (omega h)^2 / 24, 8e-5 at 5 ms; the
    // interpolation errs by less than 1e-4 of 5 periods.
    CHECK(period == Approx(expected).epsilon(5e-4));
  }
}

}  // namespace
}  // namespace plsc
