#include "sim/contact_law.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("Contacts are as hard as Gazebo makes the authors' surfaces",
          "[contact_law]") {
  // Robot on ground: kp = 1/(1/9e4 + 1/2e6), kd = 1e7/3 + 9e4; robot on robot:
  // kp = 4.5e4, kd = 2e7/3. Worked out apart from the program.
  struct Row {
    const char* why;
    double step;
    double ground_erp, ground_cfm, robot_erp, robot_cfm;
  };
  const Row rows[] = {
      {"the flat world's step", 0.005, 1.2577e-4, 2.9207e-7, 3.3749e-5,
       1.4999e-7},
      {"the tilted world's step", 0.003, 7.5467e-5, 2.9209e-7, 2.0250e-5,
       1.5000e-7},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    PhysicsOptions physics;
    physics.step = row.step;
    CHECK(RobotOnGround(physics).erp == Approx(row.ground_erp).epsilon(1e-4));
    CHECK(RobotOnGround(physics).cfm == Approx(row.ground_cfm).epsilon(1e-4));
    CHECK(RobotOnRobot(physics).erp == Approx(row.robot_erp).epsilon(1e-4));
    CHECK(RobotOnRobot(physics).cfm == Approx(row.robot_cfm).epsilon(1e-4));
  }
}

}  // namespace
}  // namespace plsc
