#include "sim/world.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/sim/bodies.h"
#include "tests/sim/engines.h"
#include "tests/sim/free_flight.h"

namespace plsc {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

bool StepFor(World& world, double time, double step = 0.005) {
  const auto steps = std::lround(time / step);
  for (int i = 0; i < steps; ++i)
    if (!world.Step()) return false;
  return true;
}

TEST_CASE("A core falls as Galileo says", "[world]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  SimulationOptions options = test::FreeFlight(engine);
  options.physics.gravity = 9.8;
  World world(Assemble(LoneCore()), {}, options);
  REQUIRE(StepFor(world, 2));
  // The speed of a step's end acts through all of it: n (n + 1) / 2 steps.
  const double fall = 9.8 * 0.005 * 0.005 * 400 * 401 / 2;
  CHECK(world.CorePosition().z() == Approx(100 - fall).epsilon(1e-12));
  CHECK(world.MotionOf(0).velocity.z() == Approx(-9.8 * 2));
  CHECK(world.contacts() == 0);
}

TEST_CASE("Damping takes its share each step", "[world]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  SimulationOptions options = test::FreeFlight(engine);
  options.physics.damping = 1e-3;
  World world(Assemble(LoneCore()), {}, options);
  world.SetMotion(0, {{1, 0, 0}, {0, 0, 2}});
  REQUIRE(StepFor(world, 1));
  const double kept = std::pow(1 - 1e-3, 200);
  CHECK(world.MotionOf(0).velocity.x() == Approx(kept));
  CHECK(world.MotionOf(0).spin.z() == Approx(2 * kept));
}

TEST_CASE("A tumbling core keeps its energy and spin", "[world]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const Assembly assembly = Assemble(LoneCore());
  World world(assembly, {}, test::FreeFlight(engine));
  world.SetMotion(0, {Vector3d::Zero(), {1, 0.1, 0.8}});
  const auto energy = [&] {
    const Vector3d spin = world.MotionOf(0).spin;
    return spin.dot(test::InertiaOf(assembly, world, 0) * spin) / 2;
  };
  const double energy_before = energy();
  const Vector3d spin_before = test::AngularMomentum(assembly, world);
  REQUIRE(StepFor(world, 2));
  // Turns of 1 rad/s, as joints make them. ODE integrates them to first order,
  // and what it loses grows with the square of the speed (0.1 %); the
  // articulated engine to second order (3e-6).
  CHECK(energy() ==
        Approx(energy_before).epsilon(test::Of(engine, 0.01, 1e-5)));
  // Both tell spins of a step's end at its beginning's pose (0.15 %).
  CHECK((test::AngularMomentum(assembly, world) - spin_before).norm() <
        0.01 * spin_before.norm());
}

TEST_CASE("Servos move limbs, not the robot, in free flight", "[world]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const Assembly assembly = Assemble(Cross());
  World world(assembly, {}, test::FreeFlight(engine));
  const Vector3d before = world.MassCentre();
  for (int joint = 0; joint < world.joints(); ++joint)
    world.SetJointSpeed(joint, joint % 2 == 0 ? 1 : 0.3);
  REQUIRE(StepFor(world, 0.5));
  CHECK((world.MassCentre() - before).norm() < 1e-9);
  CHECK(test::Momentum(assembly, world).norm() < 1e-9);
  // A brick of 20 g, 0.1 m out, at 1 rad/s has 2e-4 kg m2/s.
  CHECK(test::AngularMomentum(assembly, world).norm() < 2e-6);
  CHECK(world.JointAngle(0) == Approx(0.5).margin(0.01));
  CHECK(world.JointAngle(1) == Approx(0.15).margin(0.01));
}

TEST_CASE("Positive angles bend down and swing left", "[world]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  struct Row {
    const char* why;
    ModuleType type;
    Vector3d direction;  // of the limb on the core's front
  };
  const Row rows[] = {
      {"horizontal axis", ModuleType::kHorizontalJoint, -Vector3d::UnitZ()},
      {"vertical axis", ModuleType::kVerticalJoint, -Vector3d::UnitX()},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    Body body = LoneCore();
    const int joint = Mount(body, 0, Slot::kFront, row.type);
    Mount(body, joint, Slot::kFront, ModuleType::kBrick);
    World world(Assemble(body), {}, test::FreeFlight(engine));
    const Vector3d before = world.PoseOf(1).position;
    world.SetJointSpeed(0, 0.5);
    REQUIRE(StepFor(world, 0.4));
    CHECK(world.JointAngle(0) == Approx(0.2).margin(0.005));
    const Vector3d moved = world.PoseOf(1).position - before;
    CHECK(moved.dot(row.direction) > 0.001);
  }
}

/// Relative angular acceleration of two free bodies in line, joined by a hinge
/// across the line that turns with `torque`. Unknowns: the accelerations of
/// the hinge (across) and of both turns; from Newton and Euler for each body.
double HingeAcceleration(const Assembly& pair, double torque) {
  const Link& back = pair.links[0];
  const Link& front = pair.links[1];
  const double d1 = pair.hinges[0].anchor.y() - back.centre.y();
  const double d2 = front.centre.y() - pair.hinges[0].anchor.y();
  const double m1 = back.mass, m2 = front.mass;
  // Across the line: a1 = A - d1 t1 and a2 = A + d2 t2, and no outer force;
  // I1 t1 = -torque + d1 m1 a1, I2 t2 = torque - d2 m2 a2.
  Matrix3d equations;
  equations << m1 + m2, -m1 * d1, m2 * d2,             //
      -d1 * m1, back.inertia(2, 2) + d1 * d1 * m1, 0,  //
      d2 * m2, 0, front.inertia(2, 2) + d2 * d2 * m2;
  const Vector3d unknowns =
      equations.colPivHouseholderQr().solve(Vector3d(0, -torque, torque));
  return unknowns(2) - unknowns(1);
}

TEST_CASE("A servo accelerates by its torque until at its speed", "[world]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  Body body = LoneCore();
  const int joint = Mount(body, 0, Slot::kFront, ModuleType::kVerticalJoint);
  Mount(body, joint, Slot::kFront, ModuleType::kBrick);
  const Assembly pair = Assemble(body);
  SimulationOptions options = test::FreeFlight(engine);
  options.servo.max_torque = 2e-6;  // so weak that it takes a while
  World world(pair, {}, options);
  world.SetJointSpeed(0, 0.1);
  const double acceleration = HingeAcceleration(pair, 2e-6);
  REQUIRE(acceleration * 0.5 < 0.1);
  REQUIRE(acceleration * 3 > 0.1);
  REQUIRE(StepFor(world, 0.5));
  const auto speed = [&] {
    return world.MotionOf(1).spin.z() - world.MotionOf(0).spin.z();
  };
  CHECK(speed() == Approx(acceleration * 0.5).epsilon(0.01));
  REQUIRE(StepFor(world, 3));
  CHECK(speed() == Approx(0.1).epsilon(0.01));
}

TEST_CASE("Joints stop at their limits", "[world]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  for (const double direction : {-1.0, 1.0}) {
    World world(Assemble(Cross()), {}, test::FreeFlight(engine));
    for (int joint = 0; joint < world.joints(); ++joint)
      world.SetJointSpeed(joint, direction);
    REQUIRE(StepFor(world, 2));
    for (int joint = 0; joint < world.joints(); ++joint)
      CHECK(world.JointAngle(joint) ==
            Approx(direction * 0.7853982).margin(0.01));
  }
}

TEST_CASE("A core comes to rest on its bottom", "[world]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  World world(Assemble(LoneCore()), {}, test::With(engine));
  REQUIRE(StepFor(world, 0.5));
  const double depth = 0.0225 - world.CorePosition().z();
  // It falls 7.5 mm to 0.38 m/s, 1.9 mm a step: the most it can sink.
  CHECK(depth > 0);
  CHECK(depth < 0.0020);
  CHECK(world.contacts() == 4);
  CHECK(world.touched() == std::vector<bool>{true});
  CHECK(world.MotionOf(0).velocity.norm() < 1e-3);
  // The ground gives depth back at the rate kp / (kd + h kp): 2.5 % a second.
  const double kp = 1 / (1 / 9e4 + 1 / 2e6);
  const double kd = 1e7 / 3 + 9e4;
  REQUIRE(StepFor(world, 10));
  CHECK(0.0225 - world.CorePosition().z() ==
        Approx(depth * std::exp(-10 * kp / kd)).epsilon(0.02));
}

TEST_CASE("Below the friction limit a core creeps by slip alone", "[world]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const double tilt = 5 * M_PI / 180;
  World world(Assemble(LoneCore()), {TerrainType::kTilted, tilt},
              test::With(engine));
  REQUIRE(StepFor(world, 2));
  // Of the sole: its corners sank unevenly and come up again, which turns the
  // core a little.
  const auto sole = [&]() -> Vector3d {
    return world.CorePosition() - 0.0225 * world.PoseOf(0).axes.col(2);
  };
  const Vector3d before = sole();
  REQUIRE(StepFor(world, 10));
  const double way =
      (sole() - before).dot(Vector3d(0, -std::cos(tilt), -std::sin(tilt)));
  // Four contacts share the pull; each slips by 0.01 m/s per N.
  const double pull = 0.090 * 9.8 * std::sin(tilt);
  CHECK(way == Approx(10 * 0.01 * pull / 4).epsilon(0.02));
}

TEST_CASE("Beyond the friction limit a core slides as Coulomb says",
          "[world]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const double tilt = M_PI / 6;
  SimulationOptions options = test::With(engine);
  options.physics.friction = 0.3;
  options.physics.damping = 0;
  World world(Assemble(LoneCore()), {TerrainType::kTilted, tilt}, options);
  REQUIRE(StepFor(world, 1));
  const Vector3d downhill(0, -std::cos(tilt), -std::sin(tilt));
  const double before = world.MotionOf(0).velocity.dot(downhill);
  REQUIRE(StepFor(world, 1));
  const double gained = world.MotionOf(0).velocity.dot(downhill) - before;
  CHECK(gained ==
        Approx(9.8 * (std::sin(tilt) - 0.3 * std::cos(tilt))).epsilon(0.01));
}

TEST_CASE("Limbs that meet hold each other up", "[world]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  // Two arms side by side, 76 mm apart and each 0.1 m long, that can swing by
  // 45 degrees.
  Body body = LoneCore();
  const int base = Mount(body, 0, Slot::kFront, ModuleType::kBrick);
  const int left = Mount(body, base, Slot::kFront, ModuleType::kVerticalJoint);
  int brick = Mount(body, left, Slot::kFront, ModuleType::kBrick);
  const int left_hand = Mount(body, brick, Slot::kFront, ModuleType::kBrick);
  brick = Mount(body, base, Slot::kRight, ModuleType::kBrick);
  brick = Mount(body, brick, Slot::kFront, ModuleType::kBrick);
  const int right = Mount(body, brick, Slot::kLeft, ModuleType::kVerticalJoint);
  brick = Mount(body, right, Slot::kFront, ModuleType::kBrick);
  const int right_hand = Mount(body, brick, Slot::kFront, ModuleType::kBrick);
  const Assembly assembly = Assemble(body);
  for (const double direction : {-1.0, 1.0}) {
    const bool is_meeting = direction < 0;
    World world(assembly, {}, test::FreeFlight(engine));
    world.SetJointSpeed(0, direction);
    world.SetJointSpeed(1, -direction);
    REQUIRE(StepFor(world, 2));
    CHECK((std::abs(world.JointAngle(0)) < 0.6) == is_meeting);
    CHECK((world.contacts() > 0) == is_meeting);
    const auto& touched = world.touched();
    CHECK((touched[static_cast<std::size_t>(left_hand)] &&
           touched[static_cast<std::size_t>(right_hand)]) == is_meeting);
    CHECK_FALSE(touched[0]);
  }
}

TEST_CASE("The cap on contacts hides no touch", "[world]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  Body body = Cross();
  for (int brick = 2; brick <= 8; brick += 2)
    Mount(body, brick, Slot::kLeft, ModuleType::kTouchSensor);
  SimulationOptions options = test::With(engine);
  options.start_height = -0.05;  // every box is wholly below the ground
  World world(Assemble(body), {}, options);
  CHECK(world.contacts() == 0);
  REQUIRE(world.Step());
  CHECK(world.contacts() == 4 * world.links());
  CHECK(world.touched() == std::vector<bool>(body.modules.size(), true));
}

TEST_CASE("A lost state is told, not thrown", "[world]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  struct Row {
    const char* why;
    LinkMotion motion;
    double gravity;
    bool is_kept;
  };
  const Vector3d none = Vector3d::Zero();
  const Row rows[] = {
      {"at rest", {none, none}, 9.8, true},
      {"fast but possible", {{49, 0, 0}, none}, 9.8, true},
      {"too fast", {{51, 0, 0}, none}, 0, false},
      {"too much spin", {none, {0, 0, 501}}, 0, false},
      {"not a number", {{nan, 0, 0}, none}, 9.8, false},
      {"a spin that is not a number", {none, {0, nan, 0}}, 9.8, false},
      {"infinite", {{0, infinity, 0}, none}, 9.8, false},
      {"overflows within the step", {none, none}, 1e308, false},
      {"infinite gravity", {none, none}, infinity, false},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    SimulationOptions options = test::With(engine);
    options.physics.gravity = row.gravity;
    World world(Assemble(LoneCore()), {}, options);
    world.SetMotion(0, row.motion);
    CHECK(world.Step() == row.is_kept);
  }
}

TEST_CASE("Equal worlds have equal hashes, each step another", "[world]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const Assembly assembly = Assemble(Cross());
  World a(assembly, {}, test::With(engine)),
      b(assembly, {}, test::With(engine));
  CHECK(a.Hash() == b.Hash());
  REQUIRE(a.Step());
  CHECK(a.Hash() != b.Hash());
  REQUIRE(b.Step());
  CHECK(a.Hash() == b.Hash());
}

}  // namespace
}  // namespace plsc
