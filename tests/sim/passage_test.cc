#include "sim/passage.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "sim/assembly.h"
#include "tests/sim/bodies.h"
#include "tests/sim/engines.h"
#include "tests/sim/random_robot.h"
#include "tests/sim/terrains.h"

namespace plsc {
namespace {

using Eigen::Vector3d;

SimulationOptions OneSecond(EngineKind engine) {
  SimulationOptions options = test::With(engine);
  options.duration = 1;
  options.start_height.reset();
  return options;
}

TEST_CASE("A ground that tilts carries the robot along", "[passage]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const Phenotype robot = WithOscillators(Cross(), 1, 2);
  const Terrain flat, slope = test::Slope(5);
  const Lived before =
      Live(robot, flat, OneSecond(engine), {0, {0.4, 1.2, 0.3}, {}});
  REQUIRE(before.trajectory.outcome == Outcome::kCompleted);
  const LifeState after = Carry(before.end, robot, {flat, slope, 1e-4});
  const Vector3d normal(0, -std::sin(slope.tilt), std::cos(slope.tilt));
  for (std::size_t i = 0; i < after.poses.size(); ++i) {
    // As high above the new ground as above the old, and as fast.
    CHECK(normal.dot(after.poses[i].position) ==
          Approx(before.end.poses[i].position.z()).margin(1e-12));
    CHECK(normal.dot(after.motions[i].velocity) ==
          Approx(before.end.motions[i].velocity.z()).margin(1e-12));
  }
  CHECK(after.time == before.end.time);
  CHECK(after.memory == before.end.memory);
  const LifeState back = Carry(after, robot, {slope, flat, 1e-4});
  CHECK(back.core.position.isApprox(before.end.core.position, 1e-12));
}

TEST_CASE("On ground that is no plane the robot is put down anew",
          "[passage]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const Phenotype robot = WithOscillators(Cross(), 1, 2);
  const Lived before =
      Live(robot, {}, OneSecond(engine), {0, {0.4, 1.2, 0.3}, {}});
  for (const Terrain& to : test::AllTerrains()) {
    if (to.type == TerrainType::kFlat || to.type == TerrainType::kTilted)
      continue;
    const LifeState after = Carry(before.end, robot, {{}, to, 1e-3});
    const double lift = after.core.position.z() - before.end.core.position.z();
    CHECK(after.poses[3].position.z() - before.end.poses[3].position.z() ==
          Approx(lift));
    // It lands on it within the first steps and not in it.
    const Lived next = Live(robot, to, OneSecond(engine), {0, {}, &after});
    CHECK(next.trajectory.outcome == Outcome::kCompleted);
    CHECK(next.trajectory.contacts.tail(3).minCoeff() > 0);
  }
}

TEST_CASE("A life in two seasons is the life in one", "[passage]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  // Bits apart only by what is not part of the state: rotations are kept as
  // quaternions, and touch is felt anew.
  const Phenotype robot = WithOscillators(Cross(), 1, 2);
  SimulationOptions whole = OneSecond(engine);
  whole.duration = 2;
  const Lived straight = Live(robot, {}, whole, {});
  const Lived first = Live(robot, {}, OneSecond(engine), {});
  const LifeState carried = Carry(first.end, robot, {{}, {}, 1e-4});
  const Lived second = Live(robot, {}, OneSecond(engine), {0, {}, &carried});
  CHECK(second.trajectory.time(0) == Approx(1));
  CHECK(second.end.time == Approx(2));
  CHECK((second.end.core.position - straight.end.core.position).norm() < 1e-4);
  const Eigen::Index last = second.trajectory.time.size() - 1;
  CHECK(second.trajectory.joint_angle(0, last) ==
        Approx(straight.trajectory.joint_angle(
                   0, straight.trajectory.time.size() - 1))
            .margin(1e-3));
}

TEST_CASE("A life goes on from ground to ground", "[passage]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const Terrain grounds[] = {
      {}, test::Slope(5), test::RoughGround(1, 0.02, 0.2), {}};
  std::mt19937 random(11);  // any
  for (const int size : {4, 8, 12}) {
    CAPTURE(size);
    const Phenotype robot = RandomRobot(size, random);
    Lived last = Live(robot, grounds[0], OneSecond(engine), {});
    for (int season = 1; season < 4; ++season) {
      CAPTURE(season);
      const LifeState carried =
          Carry(last.end, robot, {grounds[season - 1], grounds[season], 1e-4});
      const Lived next =
          Live(robot, grounds[season], OneSecond(engine), {0, {}, &carried});
      REQUIRE(next.trajectory.outcome == Outcome::kCompleted);
      // Joints are as they were, and nothing leaps.
      const Eigen::Index end = last.trajectory.time.size() - 1;
      CHECK((next.trajectory.joint_angle.col(0) -
             last.trajectory.joint_angle.col(end))
                .norm() < 1e-9);
      CHECK((next.trajectory.core_position.col(0) - carried.core.position)
                .norm() < 1e-9);
      CHECK((next.trajectory.core_position.rightCols(1) -
             next.trajectory.core_position.leftCols(1))
                .norm() < 0.1);
      last = next;
    }
  }
}

}  // namespace
}  // namespace plsc
