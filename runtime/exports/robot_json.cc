#include "runtime/exports/robot_json.h"

#include <nlohmann/json.hpp>

#include "runtime/exports/controller_json.h"
#include "runtime/exports/exported_ground.h"
#include "runtime/exports/robot_model.h"
#include "runtime/recording/recording.h"
#include "runtime/scenario/scenario_physics.h"
#include "runtime/scenario/scenario_terrain.h"
#include "sim/ground.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Json VectorValue(const Vector3d& v) {
  // What is 0 but for its sign reads better without it.
  return Json::array({v.x() + 0.0, v.y() + 0.0, v.z() + 0.0});
}

/// By rows.
Json MatrixValue(const Matrix3d& m) {
  return Json::array(
      {VectorValue(m.row(0)), VectorValue(m.row(1)), VectorValue(m.row(2))});
}

Json BoxValue(const RobotModel& model, const Box& box) {
  const Body& body = model.phenotype.body;
  const Module& module = body.modules[static_cast<std::size_t>(box.module)];
  return {{"name", BoxName(model, box)},
          {"module", ModuleId(body, box.module)},
          {"module_type", ModuleName(module.type)},
          {"part", NameIn(kPartNames, box.part)},
          {"mass", box.mass},
          {"size", VectorValue(box.size)},
          {"centre", VectorValue(box.centre)},
          {"axes", MatrixValue(box.axes)},
          {"colour", AuthorsColour(module.type)}};
}

Json LinkValue(const RobotModel& model, std::size_t index) {
  const Link& link = model.assembly.links[index];
  Json boxes = Json::array();
  for (const Box& box : link.boxes) boxes.push_back(BoxValue(model, box));
  return {{"name", model.links[index]},
          {"mass", link.mass},
          {"centre_of_mass", VectorValue(link.centre)},
          {"inertia", MatrixValue(link.inertia)},
          {"boxes", std::move(boxes)}};
}

Json JointValue(const RobotModel& model, std::size_t index) {
  const Hinge& hinge = model.assembly.hinges[index];
  const ServoOptions& servo = model.options.servo;
  return {{"name", model.joints[index]},
          {"module", ModuleId(model.phenotype.body, hinge.module)},
          {"type", "hinge"},
          {"parent", model.links[static_cast<std::size_t>(hinge.parent)]},
          {"child", model.links[static_cast<std::size_t>(hinge.child)]},
          {"anchor", VectorValue(hinge.anchor)},
          {"axis", VectorValue(hinge.axis)},
          {"lower", -servo.range},
          {"upper", servo.range},
          {"actuator",
           {{"name", model.servos[index]},
            {"type", "speed"},
            {"max_speed", servo.max_speed},
            {"max_torque", servo.max_torque}}}};
}

Json SensorsValue(const RobotModel& model) {
  Json sensors = Json::array();
  sensors.push_back({{"name", model.imu},
                     {"type", "imu"},
                     {"link", model.links[0]},
                     {"position", VectorValue(Vector3d::Zero())}});
  for (const TouchSensor& touch : model.touch_sensors) {
    const Box& box = model.assembly.links[touch.link].boxes[touch.box];
    sensors.push_back({{"name", touch.name},
                       {"type", "touch"},
                       {"link", model.links[touch.link]},
                       {"box", BoxName(model, box)}});
  }
  return sensors;
}

Json PhysicsValue(const PhysicsOptions& physics) {
  // All of them: a constant more does not compile until it is written, too.
  const auto& [step, engine, solver, solver_iterations, max_direct_links,
               gravity, world_erp, world_cfm, friction, slip, robot_kp,
               robot_kd, ground_kp, ground_kd, damping, correcting_speed,
               surface_layer, max_speed, max_spin, max_solver_failures] =
      physics;
  return {{"step", step},
          {"engine", NameIn(kEngineNames, engine)},
          {"solver", solver == Solver::kDirect ? "direct" : "iterative"},
          {"solver_iterations", solver_iterations},
          {"max_direct_links", max_direct_links},
          {"gravity", gravity},
          {"world_erp", world_erp},
          {"world_cfm", world_cfm},
          {"friction", friction},
          {"slip", slip},
          {"robot_kp", robot_kp},
          {"robot_kd", robot_kd},
          {"ground_kp", ground_kp},
          {"ground_kd", ground_kd},
          {"damping", damping},
          {"correcting_speed", correcting_speed},
          {"surface_layer", surface_layer},
          {"max_speed", max_speed},
          {"max_spin", max_spin},
          {"max_solver_failures", max_solver_failures}};
}

Json HeightsValue(const ExportedGround& ground) {
  Json rows = Json::array();
  for (Eigen::Index row = 0; row < ground.heights.rows(); ++row) {
    Json& values = rows.emplace_back(Json::array());
    for (Eigen::Index column = 0; column < ground.heights.cols(); ++column)
      values.push_back(ground.heights(row, column));
  }
  return rows;
}

Json BoxesValue(const ExportedGround& ground) {
  Json boxes = Json::array();
  for (const StaticBox& box : ground.boxes)
    boxes.push_back(
        {{"centre", VectorValue(box.centre)}, {"size", VectorValue(box.size)}});
  return boxes;
}

/// The plane, and what rises from it.
Json GroundValue(const Terrain& terrain) {
  const ExportedGround ground = GroundOf(terrain);
  Json value{{"type", NameIn(kTerrainNames, terrain.type)},
             {"scenario", PrintTerrain(terrain)},
             {"normal", VectorValue(GroundNormal(terrain))}};
  if (ground.reach > 0) value["reach"] = ground.reach;
  if (ground.heights.size() > 0) value["heights"] = HeightsValue(ground);
  if (!ground.boxes.empty()) value["boxes"] = BoxesValue(ground);
  return value;
}

}  // namespace

std::string RobotJson(const RobotModel& model) {
  Json links = Json::array();
  for (std::size_t i = 0; i < model.links.size(); ++i)
    links.push_back(LinkValue(model, i));
  Json joints = Json::array();
  Json apart = Json::array();
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Hinge& hinge = model.assembly.hinges[i];
    joints.push_back(JointValue(model, i));
    apart.push_back({model.links[static_cast<std::size_t>(hinge.parent)],
                     model.links[static_cast<std::size_t>(hinge.child)]});
  }
  return ReadableJson({{"plsc_robot", 1},
                       {"name", model.name},
                       {"environment", model.environment},
                       {"mass", TotalMass(model.assembly)},
                       {"start",
                        {{"position", VectorValue(model.start.position)},
                         {"axes", MatrixValue(model.start.axes)}}},
                       {"links", std::move(links)},
                       {"joints", std::move(joints)},
                       {"sensors", SensorsValue(model)},
                       {"never_collide", std::move(apart)},
                       {"ground", GroundValue(model.terrain)},
                       {"physics", PhysicsValue(model.options.physics)},
                       {"controller", ControllerValue(model)}});
}

}  // namespace plsc
