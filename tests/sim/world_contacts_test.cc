#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/simulate.h"
#include "tests/sim/bodies.h"
#include "tests/sim/engines.h"
#include "tests/sim/terrains.h"

namespace plsc {
namespace {

using Eigen::Vector3d;

/// Steps a lone core for `time` s and gives where it is.
LinkPose CoreAfter(EngineKind engine, double time, const Terrain& terrain,
                   const Spot& spot,
                   const Vector3d& velocity = Vector3d::Zero()) {
  SimulationOptions options = test::With(engine);
  options.start_height.reset();
  const Assembly core = Assemble(LoneCore());
  World world(core, terrain, options, StartOf(core, terrain, options, spot));
  world.SetMotion(0, {velocity, Vector3d::Zero()});
  for (int i = 0; i < std::lround(time / 0.005); ++i) REQUIRE(world.Step());
  CHECK(world.touched()[0]);
  return world.PoseOf(0);
}

TEST_CASE("A core rests on a step and on the ground before it",
          "[world_contacts]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const Terrain stairs = test::Stairs(0.05, 0.3, 3);
  CHECK(CoreAfter(engine, 1, stairs, {0, 0.15, 0}).position.z() ==
        Approx(0.0225).margin(5e-4));
  CHECK(CoreAfter(engine, 1, stairs, {0, 0.45, 0}).position.z() ==
        Approx(0.0725).margin(5e-4));
  CHECK(CoreAfter(engine, 1, stairs, {0, 5, 0}).position.z() ==
        Approx(0.1725).margin(5e-4));
}

TEST_CASE("A step stops a core that slides into it", "[world_contacts]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  // 0.5 m/s against friction 1: it would slide 13 mm, and a bit by slip.
  const double free =
      CoreAfter(engine, 1, {}, {0, 0.245, 0}, {0, 0.5, 0}).position.y();
  CHECK(free > 0.2565);
  const double stopped = CoreAfter(engine, 1, test::Stairs(0.05, 0.3, 3),
                                   {0, 0.245, 0}, {0, 0.5, 0})
                             .position.y();
  CHECK(stopped < 0.3 - 0.0445 + 1.5e-3);
}

TEST_CASE("A core lies on rough ground as on its tangent", "[world_contacts]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  // Hills of 4 m are a plane to a core.
  const Terrain hills = test::RoughGround(2, 0.3, 4);
  const HeightField field(hills.rough);
  const Spot spot{0.8, 1.1, 0};
  const HeightField::Point ground = field.At(spot.x, spot.y);
  const Vector3d normal =
      Vector3d(-ground.slope_x, -ground.slope_y, 1).normalized();
  REQUIRE(normal.z() < 0.999);
  const LinkPose pose = CoreAfter(engine, 1, hills, spot);
  CHECK(pose.axes.col(2).dot(normal) > std::cos(2 * M_PI / 180));
  const double height = field.At(pose.position.x(), pose.position.y()).height;
  CHECK((pose.position.z() - height) * normal.z() ==
        Approx(0.0225).margin(2e-3));
}

TEST_CASE("Robots live on every ground", "[world_contacts]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const Phenotype robot = WithOscillators(Cross(), 1, 2);
  SimulationOptions options = test::With(engine);
  options.duration = 5;
  options.start_height.reset();
  for (const Terrain& terrain : test::AllTerrains()) {
    INFO(static_cast<int>(terrain.type));
    for (const double place : {0.0, 1.7}) {
      const Lived life =
          Live(robot, terrain, options, {0, {place, place, 1}, {}});
      CHECK(life.trajectory.outcome == Outcome::kCompleted);
      CHECK(life.trajectory.contacts.tail(5).maxCoeff() > 0);
      // It stays on it.
      CHECK(Gap(Assemble(robot.body), life.end.core, terrain) > -0.06);
      CHECK(life.trajectory.state_hash ==
            Live(robot, terrain, options, {0, {place, place, 1}, {}})
                .trajectory.state_hash);
    }
  }
}

TEST_CASE("Grounds differ by their parameters", "[world_contacts]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const Phenotype robot = WithOscillators(Cross(), 1, 2);
  SimulationOptions options = test::With(engine);
  options.duration = 3;
  options.start_height.reset();
  const auto hash = [&](const Terrain& terrain) {
    return Live(robot, terrain, options, {0, {1, 1, 0}, {}})
        .trajectory.state_hash;
  };
  CHECK(hash(test::RoughGround(1, 0.02, 0.2)) !=
        hash(test::RoughGround(2, 0.02, 0.2)));
  CHECK(hash(test::ObstacleField(1, 0.2, 0.1, 0.02)) !=
        hash(test::ObstacleField(2, 0.2, 0.1, 0.02)));
  CHECK(hash(test::RoughGround(1, 0, 0.2)) != 0);
}

}  // namespace
}  // namespace plsc
