#include "runtime/exports/robot_model.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/sim/bodies.h"

namespace plsc {
namespace {

Body Sensing() {
  Body body = LoneCore();
  const int joint = Mount(body, 0, Slot::kFront, ModuleType::kVerticalJoint);
  const int brick = Mount(body, joint, Slot::kFront, ModuleType::kBrick);
  Mount(body, brick, Slot::kRight, ModuleType::kTouchSensor);
  Mount(body, 0, Slot::kLeft, ModuleType::kTouchSensor);
  return body;
}

TEST_CASE("A robot's parts are named after their modules", "[robot_model]") {
  const RobotModel model = ModelOf(
      {"walker", "flat"}, WithOscillators(Sensing(), 2, 2), ExportedOptions());
  CHECK(model.links == std::vector<std::string>{"core", "link_2"});
  CHECK(model.joints == std::vector<std::string>{"joint_2"});
  CHECK(model.servos == std::vector<std::string>{"servo_2"});
  std::vector<std::string> boxes;
  for (const Link& link : model.assembly.links)
    for (const Box& box : link.boxes)
      boxes.push_back(BoxName(model.phenotype.body, box));
  CHECK(boxes == std::vector<std::string>{"core_1", "frame_2", "sensor_1s3",
                                          "servo_2", "plate_2", "brick_3",
                                          "sensor_3s2"});
  REQUIRE(model.touch_sensors.size() == 2);
  CHECK(model.touch_sensors[0].name == "touch_3s2");
  CHECK(model.touch_sensors[0].link == 1);
  CHECK(model.touch_sensors[1].name == "touch_1s3");
  CHECK(model.touch_sensors[1].link == 0);
}

TEST_CASE("A link's frame is at its hinge", "[robot_model]") {
  const Assembly assembly = Assemble(Sensing());
  CHECK(FrameOf(assembly, 0) == Eigen::Vector3d::Zero());
  CHECK(FrameOf(assembly, 1) == assembly.hinges[0].anchor);
}

TEST_CASE("Exported robots are those of the default profile, at rest",
          "[robot_model]") {
  const SimulationOptions options = ExportedOptions();
  CHECK(options.controller == ControllerMode::kCoupled);
  CHECK_FALSE(options.start_height);
  CHECK(options.physics == PhysicsOptions{});
  const RobotModel model = ModelOf({"core", "flat"}, {LoneCore(), {}}, options);
  // Half of its height, and the clearance.
  CHECK(model.start.position.z() ==
        Approx(0.045 / 2 + options.start_clearance).epsilon(1e-12));
  CHECK(model.start.axes.isIdentity(0));
}

TEST_CASE("A file's notes name the robot and the servo's numbers",
          "[robot_model]") {
  const std::string notes =
      NotesOn(ModelOf({"a", "b"}, {LoneCore(), {}}, ExportedOptions()));
  CHECK(notes.find("Robot a, developed in b;") == 0);
  CHECK(notes.find("0.9 (target - angle)") != std::string::npos);
  CHECK(notes.find("0.17658 N m") != std::string::npos);
  CHECK(notes.find("flat ground, gravity 9.8 m/s2") != std::string::npos);
  CHECK(notes.find("coupled") != std::string::npos);
}

TEST_CASE("A robot starts on its own ground, and its parts take a prefix",
          "[robot_model]") {
  Terrain hill;
  hill.type = TerrainType::kTilted;
  hill.tilt = 0.1;
  const RobotModel model =
      ModelOf({"a", "b", "x_"}, {Sensing(), {}}, ExportedOptions(), hill);
  CHECK(model.start.axes.col(2).z() == Approx(std::cos(0.1)));
  CHECK(model.links[1] == "x_link_2");
  CHECK(model.joints[0] == "x_joint_2");
  CHECK(model.servos[0] == "x_servo_2");
  CHECK(model.imu == "x_imu");
  CHECK(model.touch_sensors[0].name == "x_touch_3s2");
  CHECK(BoxName(model, model.assembly.links[0].boxes[0]) == "x_core_1");
}

}  // namespace
}  // namespace plsc
