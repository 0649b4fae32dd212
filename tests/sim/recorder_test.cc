#include "sim/recorder.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "sim/assembly.h"
#include "sim/world.h"
#include "tests/sim/bodies.h"

namespace plsc {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d FromRollPitchYaw(const Vector3d& angles) {
  return (AngleAxisd(angles.z(), Vector3d::UnitZ()) *
          AngleAxisd(angles.y(), Vector3d::UnitY()) *
          AngleAxisd(angles.x(), Vector3d::UnitX()))
      .toRotationMatrix();
}

TEST_CASE("RollPitchYaw undoes rotations about the fixed axes", "[recorder]") {
  for (const double roll : {-3.0, -1.0, 0.0, 0.5, 2.5})
    for (const double pitch : {-1.5, -0.7, 0.0, 1.2})
      for (const double yaw : {-2.9, 0.0, 0.3, 3.1}) {
        const Vector3d angles(roll, pitch, yaw);
        CHECK((RollPitchYaw(FromRollPitchYaw(angles)) - angles).norm() < 1e-12);
      }
}

TEST_CASE("Straight up or down, RollPitchYaw is finite and still fits",
          "[recorder]") {
  for (const double pitch : {-M_PI / 2, M_PI / 2}) {
    const Matrix3d axes = FromRollPitchYaw({0.4, pitch, 0.2});
    const Vector3d angles = RollPitchYaw(axes);
    CHECK(angles.allFinite());
    CHECK(angles.y() == Approx(pitch));
  }
}

TEST_CASE("A trajectory holds what was sampled, not what was announced",
          "[recorder]") {
  const Assembly assembly = Assemble(Cross());
  World world(assembly, {}, {});
  Recorder recorder(world, 10, 0.2);
  recorder.Sample(world, 0);
  REQUIRE(world.Step());
  recorder.Sample(world, 0.005);
  const Trajectory life = recorder.Finish(world, 1);
  CHECK(life.outcome == Outcome::kCompleted);
  CHECK(life.steps == 1);
  CHECK(life.time.size() == 2);
  CHECK(life.time(1) == 0.005);
  CHECK(life.core_position.cols() == 2);
  CHECK(life.core_position.col(0) == Vector3d(0, 0, 0.03));
  CHECK(life.core_orientation.cols() == 2);
  CHECK(life.mass_centre.cols() == 2);
  CHECK(life.joint_angle.rows() == 4);
  CHECK(life.joint_angle.cols() == 2);
  CHECK(life.contacts.size() == 2);
  CHECK(life.state_hash == world.Hash());
}

}  // namespace
}  // namespace plsc
