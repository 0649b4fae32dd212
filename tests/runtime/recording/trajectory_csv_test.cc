#include "runtime/recording/trajectory_csv.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("a trajectory is a table with a line a sample", "[trajectory]") {
  Trajectory trajectory;
  trajectory.time.resize(2);
  trajectory.time << 0, 0.2;
  trajectory.core_position = Eigen::Matrix3Xd::Constant(3, 2, 1);
  trajectory.mass_centre = Eigen::Matrix3Xd::Constant(3, 2, 2);
  trajectory.core_orientation = Eigen::Matrix3Xd::Constant(3, 2, -0.5);
  trajectory.contacts.resize(2);
  trajectory.contacts << 0, 4;
  trajectory.joint_angle = Eigen::MatrixXd::Constant(1, 2, 0.1);
  CHECK(TrajectoryCsv(trajectory) ==
        "time,x,y,z,mass_x,mass_y,mass_z,roll,pitch,yaw,contacts,joint1\n"
        "0,1,1,1,2,2,2,-0.5,-0.5,-0.5,0,0.1\n"
        "0.2,1,1,1,2,2,2,-0.5,-0.5,-0.5,4,0.1\n");
}

}  // namespace
}  // namespace plsc
