// Names and sensors are given once, here, so that all formats of one robot
// agree in them: links and joints by the ids of modules, which are the ids of
// every other output of plsc. Link i + 1 is what hinge i moves, as Assemble has
// it; formats rely on that (FrameOf).

#include "runtime/exports/robot_model.h"

#include <fmt/format.h>

#include <cassert>
#include <utility>

#include "runtime/exports/exported_ground.h"
#include "runtime/recording/recording.h"
#include "runtime/scenario/scenario_physics.h"
#include "runtime/scenario/scenario_profile.h"

namespace plsc {

namespace {

void AddTouchSensors(RobotModel& model) {
  const auto& links = model.assembly.links;
  std::vector<TouchSensor> by_module(model.phenotype.body.modules.size());
  for (std::size_t link = 0; link < links.size(); ++link)
    for (std::size_t box = 0; box < links[link].boxes.size(); ++box) {
      const Box& one = links[link].boxes[box];
      if (one.part == Part::kSensor)
        by_module[static_cast<std::size_t>(one.module)] = {
            model.prefix + "touch_" +
                ModuleId(model.phenotype.body, one.module),
            one.module, link, box};
    }
  for (TouchSensor& sensor : by_module)
    if (!sensor.name.empty()) model.touch_sensors.push_back(std::move(sensor));
}

}  // namespace

RobotModel ModelOf(const RobotTitle& title, const Phenotype& phenotype,
                   const SimulationOptions& options, const Terrain& terrain) {
  RobotModel model;
  model.name = title.name;
  model.environment = title.environment;
  model.prefix = title.prefix;
  model.phenotype = phenotype;
  model.assembly = Assemble(phenotype.body);
  model.options = options;
  model.terrain = terrain;
  model.start = StartOf(model.assembly, terrain, options, {});
  model.imu = model.prefix + "imu";
  model.links.push_back(model.prefix + "core");
  for (const Hinge& hinge : model.assembly.hinges) {
    const std::string id = ModuleId(phenotype.body, hinge.module);
    model.links.push_back(model.prefix + "link_" + id);
    model.joints.push_back(model.prefix + "joint_" + id);
    model.servos.push_back(model.prefix + "servo_" + id);
  }
  AddTouchSensors(model);
  return model;
}

SimulationOptions ExportedOptions() {
  return OptionsFor(ProfileScenario(Profile::kPaper),
                    ProfileSeason(Profile::kPaper, {}));
}

std::string BoxName(const Body& body, const Box& box) {
  return std::string(NameIn(kPartNames, box.part)) + "_" +
         ModuleId(body, box.module);
}

std::string BoxName(const RobotModel& model, const Box& box) {
  return model.prefix + BoxName(model.phenotype.body, box);
}

Eigen::Vector3d FrameOf(const Assembly& assembly, std::size_t link) {
  return link == 0 ? Eigen::Vector3d::Zero().eval()
                   : assembly.hinges[link - 1].anchor;
}

std::array<double, 3> AuthorsColour(ModuleType type) {
  switch (type) {
    case ModuleType::kCore:
      return {1, 1, 0};
    case ModuleType::kBrick:
      return {0, 0, 1};
    case ModuleType::kHorizontalJoint:
      return {1, 0.08, 0.58};
    case ModuleType::kVerticalJoint:
      return {0.7, 0, 0};
    case ModuleType::kTouchSensor:
      return {0.7, 0.7, 0.7};
  }
  assert(false);
  return {};
}

std::string NotesOn(const RobotModel& model) {
  const ServoOptions& servo = model.options.servo;
  const PhysicsOptions& physics = model.options.physics;
  return fmt::format(
      "Robot {}, developed in {}; written by plsc export.\n"
      "Metres, kilograms, seconds, radians; x right, y front, z up.\n"
      "A servo's motor holds a speed with up to {} N m. plsc sets that speed\n"
      "{} times a second to {} (target - angle), -{} to {} rad/s; targets\n"
      "are in the exports controller-c and controller-json; the controller is\n"
      "{}.\n"
      "Simulated on {}, gravity {} m/s2,\n"
      "friction {}, in steps of {} s.",
      model.name, model.environment, servo.max_torque, servo.update_rate,
      servo.gain, servo.max_speed, servo.max_speed,
      NameIn(kControllerNames, model.options.controller),
      GroundText(model.terrain), physics.gravity, physics.friction,
      physics.step);
}

}  // namespace plsc
