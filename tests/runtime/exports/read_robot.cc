#include "tests/runtime/exports/read_robot.h"

#include <catch2/catch.hpp>

#include "compiler/environment_text.h"
#include "runtime/develop/develop.h"
#include "tests/runtime/develop/compile_text.h"
#include "tests/runtime/develop/reference_cases.h"
#include "tests/sim/golden_robots.h"

namespace plsc::test {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using nlohmann::json;

// m, what the issue asks for; files hold 15 digits.
constexpr double kNear = 1e-6;
constexpr double kMass = 1e-9;  // kg
// kg m2; the least moment of a link is 3e-7. MuJoCo leaves elements below
// 1e-12 beside the diagonal alone.
constexpr double kInertia = 2e-12;
// rad, N m, rad/s.
constexpr double kLimit = 1e-12;

Vector3d VectorOf(const json& numbers) {
  return {numbers.at(0).get<double>(), numbers.at(1).get<double>(),
          numbers.at(2).get<double>()};
}

void CheckBox(const ReadBox& read, const Box& box) {
  CHECK((read.centre - box.centre).norm() < kNear);
  CHECK((read.axes - box.axes).norm() < kNear);
  CHECK((read.size - box.size).norm() < kNear);
}

void CheckLink(const ReadLink& read, const Link& link, const Body& body) {
  CHECK(std::abs(read.mass - link.mass) < kMass);
  CHECK((read.centre - link.centre).norm() < kNear);
  CHECK((read.inertia - link.inertia).norm() < kInertia);
  REQUIRE(read.boxes.size() == link.boxes.size());
  for (const Box& box : link.boxes) {
    const std::string name = BoxName(body, box);
    INFO(name);
    REQUIRE(read.boxes.contains(name));
    CheckBox(read.boxes.at(name), box);
  }
}

void CheckJoint(const ReadJoint& read, const Hinge& hinge,
                const RobotModel& model) {
  const ServoOptions& servo = model.options.servo;
  CHECK(read.parent == model.links[static_cast<std::size_t>(hinge.parent)]);
  CHECK(read.child == model.links[static_cast<std::size_t>(hinge.child)]);
  CHECK((read.anchor - hinge.anchor).norm() < kNear);
  CHECK((read.axis - hinge.axis).norm() < kNear);
  CHECK(std::abs(read.lower + servo.range) < kLimit);
  CHECK(std::abs(read.upper - servo.range) < kLimit);
  CHECK(std::abs(read.torque - servo.max_torque) < kLimit);
  CHECK(std::abs(read.speed - servo.max_speed) < kLimit);
}

/// Numbers as the file has them, in the order in which bodies are read.
void TakeNumbers(const json& module, std::size_t& next, Body& body) {
  Module& one = body.modules.at(next++);
  if (one.type != ModuleType::kTouchSensor)
    one.number = std::stoi(module.at("id").get<std::string>());
  if (!module.contains("children")) return;
  for (const json& child : module.at("children"))
    TakeNumbers(child, next, body);
}

Body NumberedBody(const json& core) {
  Body body = BodyFromJson(core);
  std::size_t next = 0;
  TakeNumbers(core, next, body);
  return body;
}

std::vector<AuthorsRobot> LoadAuthorsRobots() {
  std::vector<AuthorsRobot> robots;
  for (const json& entry : LoadAuthorsBodies()) {
    const std::string name = entry.at("case").get<std::string>();
    robots.push_back({name, ModelOfBody(NumberedBody(entry.at("body")), name),
                      entry.value("geometry", json())});
  }
  return robots;
}

/// Of each set every `stride`-th robot, as it develops.
void AddSamples(std::size_t stride, std::vector<RobotModel>& models) {
  for (const std::string& set : ReferenceSets()) {
    const std::vector<Json> cases = ReadReferenceCases(set);
    for (std::size_t i = 0; i < cases.size(); i += stride) {
      const Genotype genotype = CompileText(GenotypeText(cases[i])).genotype;
      const Source senses("--env", EnvironmentText(cases[i]));
      const auto environment = ParseEnvironment(senses, genotype.states);
      REQUIRE(environment);
      const auto phenotype = Develop(genotype, *environment);
      REQUIRE(phenotype);
      models.push_back(
          ModelOf({cases[i]["id"].dump(), set}, *phenotype, ExportedOptions()));
    }
  }
}

Body SensorsEverywhere() {
  Body body = LoneCore();
  for (const Slot slot : {Slot::kFront, Slot::kRight, Slot::kBack})
    Mount(body, 0, slot, ModuleType::kTouchSensor);
  const int joint = Mount(body, 0, Slot::kLeft, ModuleType::kVerticalJoint);
  const int brick = Mount(body, joint, Slot::kFront, ModuleType::kBrick);
  for (const Slot slot : {Slot::kFront, Slot::kRight, Slot::kLeft})
    Mount(body, brick, slot, ModuleType::kTouchSensor);
  return body;
}

/// Fourteen joints in a row, of both kinds in turn, seven to either side.
Body Snake() {
  Body body = LoneCore();
  for (const Slot slot : {Slot::kFront, Slot::kBack}) {
    int end = Mount(body, 0, slot, ModuleType::kHorizontalJoint);
    for (int i = 1; i < 7; ++i)
      end = Mount(body, end, Slot::kFront,
                  i % 2 == 0 ? ModuleType::kHorizontalJoint
                             : ModuleType::kVerticalJoint);
  }
  return body;
}

std::vector<RobotModel> LoadManyModels() {
  std::vector<RobotModel> models = {
      ModelOfBody(LoneCore(), "core alone"), ModelOfBody(Cross(), "cross"),
      ModelOfBody(SensorsEverywhere(), "sensors everywhere"),
      ModelOfBody(Snake(), "<\"snake\"> & 'co' -- ")};
  for (const AuthorsRobot& robot : AuthorsRobots())
    models.push_back(robot.model);
  // A seventh: 79 robots of all sets. All of them take half a minute.
  AddSamples(7, models);
  return models;
}

}  // namespace

RobotModel ModelOfBody(const Body& body, const std::string& name) {
  return ModelOf({name, "test"}, WithSenses(body), ExportedOptions());
}

void CheckIsModel(const ReadRobot& read, const RobotModel& model) {
  INFO(model.name << " in " << model.environment);
  REQUIRE(read.links.size() == model.links.size());
  double mass = 0;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    INFO(model.links[i]);
    REQUIRE(read.links.contains(model.links[i]));
    const ReadLink& link = read.links.at(model.links[i]);
    mass += link.mass;
    CheckLink(link, model.assembly.links[i], model.phenotype.body);
  }
  CHECK(std::abs(mass - TotalMass(model.assembly)) < kMass);
  REQUIRE(read.joints.size() == model.joints.size());
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    INFO(model.joints[i]);
    REQUIRE(read.joints.contains(model.joints[i]));
    CheckJoint(read.joints.at(model.joints[i]), model.assembly.hinges[i],
               model);
  }
  std::vector<std::string> touch;
  for (const TouchSensor& sensor : model.touch_sensors)
    touch.push_back(sensor.name);
  CHECK_THAT(read.touch_sensors, Catch::UnorderedEquals(touch));
  CHECK(read.has_imu);
}

const std::vector<AuthorsRobot>& AuthorsRobots() {
  static const std::vector<AuthorsRobot> robots = LoadAuthorsRobots();
  return robots;
}

const std::vector<RobotModel>& ManyModels() {
  static const std::vector<RobotModel> models = LoadManyModels();
  return models;
}

void CheckIsAuthors(const ReadRobot& read, const AuthorsRobot& robot) {
  INFO(robot.name);
  const Body& body = robot.model.phenotype.body;
  const auto& hinges = robot.model.assembly.hinges;
  const json& links = robot.geometry.at("links");
  REQUIRE(read.links.size() == links.size());
  for (std::size_t i = 0; i < robot.model.links.size(); ++i) {
    const std::string name =
        i == 0 ? "Core" : Chain(body, hinges[i - 1].module) + "_Leg";
    INFO(name);
    const json& expected = links.at(name);
    const ReadLink& link = read.links.at(robot.model.links[i]);
    CHECK(std::abs(link.mass - expected.at("mass").get<double>()) < kMass);
    CHECK((link.centre - VectorOf(expected.at("com"))).norm() < kNear);
    std::size_t next = 0;
    for (int row = 0; row < 3; ++row)
      for (int column = row; column < 3; ++column)
        CHECK(std::abs(link.inertia(row, column) -
                       expected.at("inertia").at(next++).get<double>()) <
              kInertia);
  }
  std::map<std::string, json> joints;
  for (const json& joint : robot.geometry.at("joints"))
    joints[joint.at("name").get<std::string>()] = joint;
  REQUIRE(read.joints.size() == joints.size());
  for (std::size_t i = 0; i < hinges.size(); ++i) {
    const json& expected = joints.at(
        "component_" + Chain(body, hinges[i].module) + "_ActiveHinge__joint");
    const ReadJoint& joint = read.joints.at(robot.model.joints[i]);
    CHECK((joint.anchor - VectorOf(expected.at("anchor"))).norm() < kNear);
    CHECK((joint.axis - VectorOf(expected.at("axis"))).norm() < kNear);
  }
}

}  // namespace plsc::test
