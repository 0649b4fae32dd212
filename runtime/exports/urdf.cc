#include "runtime/exports/urdf.h"

#include <cstddef>

#include "runtime/exports/number_text.h"
#include "runtime/exports/robot_model.h"
#include "runtime/text/xml.h"

namespace plsc {

namespace {

using Eigen::Vector3d;

std::string Notes(const RobotModel& model) {
  return NotesOn(model) +
         "\nURDF has no place for ground, gravity, step and start, which is "
         "with the core at\n" +
         NumbersText(model.start.position) + ", turned by " +
         NumbersText(FixedAngles(model.start.axes)) +
         " (roll, pitch, yaw).\n"
         "The gazebo elements are sensors and contacts; others skip them.";
}

XmlElement Origin(const Vector3d& position, const Eigen::Matrix3d& axes) {
  XmlElement origin{"origin", {{"xyz", NumbersText(position)}}};
  if (!axes.isIdentity(0))
    origin.attributes.emplace_back("rpy", NumbersText(FixedAngles(axes)));
  return origin;
}

XmlElement UrdfInertial(const Link& link, const Vector3d& frame) {
  const Eigen::Matrix3d& i = link.inertia;
  return {"inertial",
          {},
          {Origin(link.centre - frame, Eigen::Matrix3d::Identity()),
           {"mass", {{"value", NumberText(link.mass)}}},
           {"inertia",
            {{"ixx", NumberText(i(0, 0))},
             {"ixy", NumberText(i(0, 1))},
             {"ixz", NumberText(i(0, 2))},
             {"iyy", NumberText(i(1, 1))},
             {"iyz", NumberText(i(1, 2))},
             {"izz", NumberText(i(2, 2))}}}}};
}

/// Gazebo's reader takes shapes whose names do not begin so for those of
/// another link, fixed to it, and forgets their friction.
std::string ShapeName(const RobotModel& model, std::size_t link,
                      const std::string& kind, const Box& box) {
  return model.links[link] + "_" + kind + "_" +
         BoxName(model.phenotype.body, box);
}

std::string BaseName(const RobotModel& model) {
  return model.prefix + "base_link";
}

/// A box as it is seen ("visual") or felt ("collision").
XmlElement Shape(const char* kind, const RobotModel& model, std::size_t link,
                 const Box& box) {
  const Vector3d frame = FrameOf(model.assembly, link);
  return {kind,
          {{"name", ShapeName(model, link, kind, box)}},
          {Origin(box.centre - frame, box.axes),
           {"geometry", {}, {{"box", {{"size", NumbersText(box.size)}}}}}}};
}

std::string MaterialOf(const RobotModel& model, const Box& box) {
  const auto module = static_cast<std::size_t>(box.module);
  return "plsc_" +
         std::string(ModuleName(model.phenotype.body.modules[module].type));
}

XmlElement LinkElement(const RobotModel& model, std::size_t index) {
  const Link& link = model.assembly.links[index];
  const Vector3d frame = FrameOf(model.assembly, index);
  XmlElement element{
      "link", {{"name", model.links[index]}}, {UrdfInertial(link, frame)}};
  for (const Box& box : link.boxes) {
    XmlElement seen = Shape("visual", model, index, box);
    seen.children.push_back({"material", {{"name", MaterialOf(model, box)}}});
    element.children.push_back(std::move(seen));
    element.children.push_back(Shape("collision", model, index, box));
  }
  return element;
}

XmlElement JointElement(const RobotModel& model, std::size_t hinge) {
  const Hinge& one = model.assembly.hinges[hinge];
  const ServoOptions& servo = model.options.servo;
  const auto parent = static_cast<std::size_t>(one.parent);
  const auto child = static_cast<std::size_t>(one.child);
  return {"joint",
          {{"name", model.joints[hinge]}, {"type", "revolute"}},
          {Origin(one.anchor - FrameOf(model.assembly, parent),
                  Eigen::Matrix3d::Identity()),
           {"parent", {{"link", model.links[parent]}}},
           {"child", {{"link", model.links[child]}}},
           {"axis", {{"xyz", NumbersText(one.axis)}}},
           {"limit",
            {{"lower", NumberText(-servo.range)},
             {"upper", NumberText(servo.range)},
             {"effort", NumberText(servo.max_torque)},
             {"velocity", NumberText(servo.max_speed)}}},
           {"dynamics", {{"damping", "0"}, {"friction", "0"}}}}};
}

XmlElement Transmission(const RobotModel& model, std::size_t hinge) {
  const XmlElement speed =
      XmlText("hardwareInterface", "hardware_interface/VelocityJointInterface");
  return {"transmission",
          {{"name", "transmission_" + model.joints[hinge]}},
          {XmlText("type", "transmission_interface/SimpleTransmission"),
           {"joint", {{"name", model.joints[hinge]}}, {speed}},
           {"actuator",
            {{"name", model.servos[hinge]}},
            {speed, XmlText("mechanicalReduction", "1")}}}};
}

/// Gazebo's name of the shape that a touch sensor feels: it numbers those of a
/// link, but for the first, and makes the core a part of the base.
std::string CollisionInGazebo(const RobotModel& model,
                              const TouchSensor& touch) {
  const Box& box = model.assembly.links[touch.link].boxes[touch.box];
  const std::string joined =
      touch.link == 0 ? BaseName(model) + "_fixed_joint_lump__" : "";
  return joined + ShapeName(model, touch.link, "collision", box) +
         "_collision" + (touch.box == 0 ? "" : "_" + std::to_string(touch.box));
}

XmlElement GazeboSensor(const std::string& name, const std::string& type,
                        std::vector<XmlElement> settings) {
  XmlElement sensor{"sensor", {{"name", name}, {"type", type}}};
  sensor.children = std::move(settings);
  sensor.children.push_back(XmlText("always_on", "true"));
  return sensor;
}

XmlElement ForGazebo(const RobotModel& model, std::size_t index) {
  const PhysicsOptions& physics = model.options.physics;
  XmlElement gazebo{"gazebo",
                    {{"reference", model.links[index]}},
                    {XmlText("selfCollide", "true"),
                     XmlText("mu1", NumberText(physics.friction)),
                     XmlText("mu2", NumberText(physics.friction)),
                     XmlText("kp", NumberText(physics.robot_kp)),
                     XmlText("kd", NumberText(physics.robot_kd))}};
  if (index == 0) gazebo.children.push_back(GazeboSensor(model.imu, "imu", {}));
  for (const TouchSensor& touch : model.touch_sensors)
    if (touch.link == index)
      gazebo.children.push_back(GazeboSensor(
          touch.name, "contact",
          {{"contact",
            {},
            {XmlText("collision", CollisionInGazebo(model, touch))}}}));
  return gazebo;
}

/// Where tools of ROS begin: a link without inertia, since their solvers give
/// the root none. Gazebo joins it and the core into one link.
XmlElement BaseLink(const RobotModel& model) {
  return {"link", {{"name", BaseName(model)}}};
}

XmlElement BaseJoint(const RobotModel& model) {
  return {"joint",
          {{"name", model.prefix + "base_joint"}, {"type", "fixed"}},
          {{"parent", {{"link", BaseName(model)}}},
           {"child", {{"link", model.links[0]}}}}};
}

XmlElement Material(ModuleType type) {
  const auto colour = AuthorsColour(type);
  return {
      "material",
      {{"name", "plsc_" + std::string(ModuleName(type))}},
      {{"color",
        {{"rgba", NumbersText({colour[0], colour[1], colour[2]}) + " 1"}}}}};
}

}  // namespace

std::string Urdf(const RobotModel& model) {
  XmlElement robot{"robot", {{"name", model.name}}};
  auto& parts = robot.children;
  parts.push_back(XmlComment(Notes(model)));
  for (const ModuleType type :
       {ModuleType::kCore, ModuleType::kBrick, ModuleType::kVerticalJoint,
        ModuleType::kHorizontalJoint, ModuleType::kTouchSensor})
    parts.push_back(Material(type));
  parts.push_back(BaseLink(model));
  parts.push_back(BaseJoint(model));
  for (std::size_t i = 0; i < model.links.size(); ++i)
    parts.push_back(LinkElement(model, i));
  for (std::size_t i = 0; i < model.joints.size(); ++i)
    parts.push_back(JointElement(model, i));
  for (std::size_t i = 0; i < model.joints.size(); ++i)
    parts.push_back(Transmission(model, i));
  for (std::size_t i = 0; i < model.links.size(); ++i)
    parts.push_back(ForGazebo(model, i));
  return PrintXml(robot);
}

}  // namespace plsc
