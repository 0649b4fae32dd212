#include "runtime/exports/robot_model.h"

#include <catch2/catch.hpp>

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
}

}  // namespace
}  // namespace plsc
