#include "runtime/exports/robot_json.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/runtime/exports/read_robot.h"
#include "tests/sim/bodies.h"

namespace plsc {
namespace {

using nlohmann::json;

Eigen::Vector3d VectorIn(const json& numbers) {
  return {numbers.at(0).get<double>(), numbers.at(1).get<double>(),
          numbers.at(2).get<double>()};
}

Eigen::Matrix3d MatrixOf(const json& rows) {
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i)
    matrix.row(i) = VectorIn(rows.at(static_cast<std::size_t>(i)));
  return matrix;
}

test::ReadRobot Read(const json& file) {
  test::ReadRobot read;
  for (const json& link : file["links"]) {
    test::ReadLink& one = read.links[link["name"]];
    one.mass = link["mass"];
    one.centre = VectorIn(link["centre_of_mass"]);
    one.inertia = MatrixOf(link["inertia"]);
    for (const json& box : link["boxes"])
      one.boxes[box["name"]] = {VectorIn(box["centre"]), MatrixOf(box["axes"]),
                                VectorIn(box["size"])};
  }
  for (const json& joint : file["joints"])
    read.joints[joint["name"]] = {joint["parent"],
                                  joint["child"],
                                  VectorIn(joint["anchor"]),
                                  VectorIn(joint["axis"]),
                                  joint["lower"],
                                  joint["upper"],
                                  joint["actuator"]["max_torque"],
                                  joint["actuator"]["max_speed"]};
  for (const json& sensor : file["sensors"]) {
    if (sensor["type"] == "imu") read.has_imu = true;
    if (sensor["type"] == "touch") read.touch_sensors.push_back(sensor["name"]);
  }
  return read;
}

TEST_CASE("The JSON holds the robot that plsc simulates", "[robot_json]") {
  for (const RobotModel& model : test::ManyModels()) {
    INFO(model.name);
    const json file = json::parse(RobotJson(model));
    CheckIsModel(Read(file), model);
    CHECK(file["plsc_robot"] == 1);
    CHECK(file["name"] == model.name);
    CHECK(file["mass"] == TotalMass(model.assembly));
    CHECK(VectorIn(file["start"]["position"]) == model.start.position);
    CHECK(file["never_collide"].size() == model.joints.size());
    CHECK(file["controller"]["joints"] == model.joints);
  }
}

TEST_CASE("The JSON holds what the authors' program assembled",
          "[robot_json]") {
  int compared = 0;
  for (const test::AuthorsRobot& robot : test::AuthorsRobots()) {
    if (robot.geometry.is_null()) continue;
    ++compared;
    CheckIsAuthors(Read(json::parse(RobotJson(robot.model))), robot);
  }
  CHECK(compared == 20);
}

TEST_CASE("Numbers of the JSON are those simulated, bit for bit",
          "[robot_json]") {
  const RobotModel cross = test::ModelOfBody(Cross(), "cross");
  const json file = json::parse(RobotJson(cross));
  for (std::size_t i = 0; i < cross.links.size(); ++i) {
    const Link& link = cross.assembly.links[i];
    CHECK(file["links"][i]["mass"] == link.mass);
    CHECK(VectorIn(file["links"][i]["centre_of_mass"]) == link.centre);
    CHECK(MatrixOf(file["links"][i]["inertia"]) == link.inertia);
  }
}

}  // namespace
}  // namespace plsc
