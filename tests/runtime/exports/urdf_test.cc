#include "runtime/exports/urdf.h"

#include <urdf_parser/urdf_parser.h>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>

#include "runtime/exports/number_text.h"
#include "tests/runtime/exports/read_robot.h"

namespace plsc {
namespace {

using Eigen::Isometry3d;

Eigen::Vector3d ToEigen(const urdf::Vector3& v) {
  return {v.x, v.y, v.z};
}

Isometry3d ToEigen(const urdf::Pose& pose) {
  Isometry3d frame = Isometry3d::Identity();
  frame.translation() = ToEigen(pose.position);
  const urdf::Rotation& r = pose.rotation;
  frame.linear() = Eigen::Quaterniond(r.w, r.x, r.y, r.z).toRotationMatrix();
  return frame;
}

test::ReadLink ReadLinkOf(const urdf::Link& link, const Isometry3d& frame) {
  test::ReadLink read;
  REQUIRE(link.inertial);
  const urdf::Inertial& inertial = *link.inertial;
  const Isometry3d centre = frame * ToEigen(inertial.origin);
  read.mass = inertial.mass;
  read.centre = centre.translation();
  Eigen::Matrix3d inertia;
  inertia << inertial.ixx, inertial.ixy, inertial.ixz, inertial.ixy,
      inertial.iyy, inertial.iyz, inertial.ixz, inertial.iyz, inertial.izz;
  read.inertia = centre.linear() * inertia * centre.linear().transpose();
  for (const auto& collision : link.collision_array) {
    const Isometry3d place = frame * ToEigen(collision->origin);
    const auto box = std::dynamic_pointer_cast<urdf::Box>(collision->geometry);
    REQUIRE(box);
    const std::string prefix = link.name + "_collision_";
    REQUIRE(collision->name.starts_with(prefix));
    read.boxes[collision->name.substr(prefix.size())] = {
        place.translation(), place.linear(), ToEigen(box->dim)};
  }
  CHECK(link.visual_array.size() == link.collision_array.size());
  for (const auto& visual : link.visual_array) CHECK(visual->material);
  return read;
}

/// By forward kinematics, from the root outwards.
void ReadFrom(const urdf::Link& link, const Isometry3d& frame,
              test::ReadRobot& read) {
  read.links[link.name] = ReadLinkOf(link, frame);
  for (const auto& joint : link.child_joints) {
    CHECK(joint->type == urdf::Joint::REVOLUTE);
    const Isometry3d origin =
        frame * ToEigen(joint->parent_to_joint_origin_transform);
    test::ReadJoint& one = read.joints[joint->name];
    one.parent = joint->parent_link_name;
    one.child = joint->child_link_name;
    one.anchor = origin.translation();
    one.axis = origin.linear() * ToEigen(joint->axis);
    REQUIRE(joint->limits);
    one.lower = joint->limits->lower;
    one.upper = joint->limits->upper;
    one.torque = joint->limits->effort;
    one.speed = joint->limits->velocity;
  }
  for (const auto& child : link.child_links)
    ReadFrom(
        *child,
        frame * ToEigen(child->parent_joint->parent_to_joint_origin_transform),
        read);
}

test::ReadRobot Read(const std::string& text) {
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(text);
  INFO(text);
  REQUIRE(model);
  // Tools of ROS want a root that weighs nothing.
  const urdf::Link& root = *model->getRoot();
  CHECK(root.name.ends_with("base_link"));
  CHECK_FALSE(root.inertial);
  CHECK(root.collision_array.empty());
  REQUIRE(root.child_joints.size() == 1);
  const urdf::Joint& joint = *root.child_joints[0];
  CHECK(joint.type == urdf::Joint::FIXED);
  CHECK(ToEigen(joint.parent_to_joint_origin_transform)
            .isApprox(Isometry3d::Identity()));
  test::ReadRobot read;
  ReadFrom(*root.child_links[0], Isometry3d::Identity(), read);
  return read;
}

/// URDF itself knows none; sdf_test.cc finds them in Gazebo's extension.
test::ReadRobot WithSensorsOf(const RobotModel& model, test::ReadRobot read) {
  for (const TouchSensor& sensor : model.touch_sensors)
    read.touch_sensors.push_back(sensor.name);
  read.has_imu = true;
  return read;
}

TEST_CASE("urdfdom reads the robot that plsc simulates", "[urdf]") {
  for (const RobotModel& model : test::ManyModels())
    CheckIsModel(WithSensorsOf(model, Read(Urdf(model))), model);
}

TEST_CASE("urdfdom reads what the authors' program assembled", "[urdf]") {
  int compared = 0;
  for (const test::AuthorsRobot& robot : test::AuthorsRobots()) {
    if (robot.geometry.is_null()) continue;
    ++compared;
    CheckIsAuthors(Read(Urdf(robot.model)), robot);
  }
  CHECK(compared == 20);
}

TEST_CASE("A URDF tells what it cannot hold", "[urdf]") {
  const RobotModel& model = test::AuthorsRobots().front().model;
  CHECK(Urdf(model).find(NumbersText(model.start.position) + ", turned by 0") !=
        std::string::npos);
  SimulationOptions options = ExportedOptions();
  options.physics.gravity = 1.62;
  Terrain hill;
  hill.type = TerrainType::kTilted;
  hill.tilt = std::numbers::pi / 36;
  const std::string text =
      Urdf(ModelOf({"a", "b"}, model.phenotype, options, hill));
  CHECK(text.find("tilted: 5 deg") != std::string::npos);
  CHECK(text.find("gravity 1.62 m/s2") != std::string::npos);
}

TEST_CASE("Names of a URDF take a prefix", "[urdf]") {
  const RobotModel& plain = test::AuthorsRobots().front().model;
  const RobotModel model =
      ModelOf({"a", "b", "left_"}, plain.phenotype, plain.options);
  const urdf::ModelInterfaceSharedPtr read = urdf::parseURDF(Urdf(model));
  REQUIRE(read);
  for (const auto& [name, link] : read->links_)
    CHECK(name.starts_with("left_"));
  for (const auto& [name, joint] : read->joints_)
    CHECK(name.starts_with("left_"));
}

}  // namespace
}  // namespace plsc
