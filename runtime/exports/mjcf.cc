#include "runtime/exports/mjcf.h"

#include <cstddef>

#include "runtime/exports/mjcf_ground.h"
#include "runtime/exports/number_text.h"
#include "runtime/exports/robot_model.h"
#include "runtime/text/xml.h"

namespace plsc {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Attributes = std::vector<std::pair<std::string, std::string>>;

constexpr const char* kAloneNotes =
    "\nThe motors are stiff: a world with this robot needs <option "
    "integrator=\"implicit\"/>.";

constexpr const char* kMjcfNotes =
    "The control of an actuator is that speed.\n"
    "A touch sensor reads the force on its box, N; plsc takes any as touched.\n"
    "Not in MJCF: the slip of plsc's friction.";

// N m s/rad. The motor of plsc holds a speed exactly, up to its torque; this
// one gives way by a quarter of the largest speed at the largest torque. On
// four legs that lift a core, angles are then within 0.014 rad of ours for 8 s.
// A fourteenth of it is 0.18 rad off; at 25 times as
// much the torque's limit is met so often that legs jump (0.3 rad).
double MotorGain(const ServoOptions& servo) {
  return 4 * servo.max_torque / servo.max_speed;
}

std::string Range(double limit) {
  return NumberText(-limit) + " " + NumberText(limit);
}

/// Of our elements alone: a world that includes the robot has its own.
std::string ClassOf(const RobotModel& model) {
  return model.prefix + "plsc";
}

/// Turns without angles, which a compiler takes for degrees or radians.
void AddPose(const Vector3d& position, const Matrix3d& axes,
             Attributes& attributes) {
  attributes.emplace_back("pos", NumbersText(position));
  if (!axes.isIdentity(0))
    attributes.emplace_back("quat", QuaternionText(axes));
}

XmlElement MjcfInertial(const Link& link, const Vector3d& frame) {
  const Matrix3d& i = link.inertia;
  return {"inertial",
          {{"pos", NumbersText(link.centre - frame)},
           {"mass", NumberText(link.mass)},
           {"fullinertia", NumbersText(i.diagonal()) + " " +
                               NumbersText({i(0, 1), i(0, 2), i(1, 2)})}}};
}

XmlElement Geom(const RobotModel& model, const Box& box,
                const Vector3d& frame) {
  const Body& body = model.phenotype.body;
  const auto colour =
      AuthorsColour(body.modules[static_cast<std::size_t>(box.module)].type);
  XmlElement geom{"geom", {{"name", BoxName(model, box)}, {"type", "box"}}};
  geom.attributes.emplace_back("size", NumbersText(box.size / 2));
  AddPose(box.centre - frame, box.axes, geom.attributes);
  geom.attributes.emplace_back(
      "rgba", NumbersText({colour[0], colour[1], colour[2]}) + " 1");
  return geom;
}

/// Where a sensor of MuJoCo feels; its box, as a geom would be.
XmlElement TouchSite(const RobotModel& model, const TouchSensor& sensor,
                     const Vector3d& frame) {
  const Box& box = model.assembly.links[sensor.link].boxes[sensor.box];
  XmlElement site{"site", {{"name", sensor.name}, {"type", "box"}}};
  site.attributes.emplace_back("size", NumbersText(box.size / 2));
  AddPose(box.centre - frame, box.axes, site.attributes);
  return site;
}

XmlElement Hinged(const RobotModel& model, std::size_t hinge);

/// The link's own parts, then the links that it carries.
void FillBody(const RobotModel& model, std::size_t index, XmlElement& body) {
  const Link& link = model.assembly.links[index];
  const Vector3d frame = FrameOf(model.assembly, index);
  body.children.push_back(MjcfInertial(link, frame));
  for (const Box& box : link.boxes)
    body.children.push_back(Geom(model, box, frame));
  for (const TouchSensor& sensor : model.touch_sensors)
    if (sensor.link == index)
      body.children.push_back(TouchSite(model, sensor, frame));
  const auto& hinges = model.assembly.hinges;
  for (std::size_t i = 0; i < hinges.size(); ++i)
    if (static_cast<std::size_t>(hinges[i].parent) == index)
      body.children.push_back(Hinged(model, i));
}

// Recursion is as deep as joints are in a row.
XmlElement Hinged(const RobotModel& model, std::size_t hinge) {
  const Hinge& one = model.assembly.hinges[hinge];
  const auto child = static_cast<std::size_t>(one.child);
  const Vector3d parent =
      FrameOf(model.assembly, static_cast<std::size_t>(one.parent));
  XmlElement body{
      "body",
      {{"name", model.links[child]}, {"pos", NumbersText(one.anchor - parent)}},
      {{"joint",
        {{"name", model.joints[hinge]}, {"axis", NumbersText(one.axis)}}}}};
  FillBody(model, child, body);
  return body;
}

/// Every attribute that defaults of the including world could change.
XmlElement GeomDefaults(const PhysicsOptions& physics) {
  return {"geom",
          {{"contype", "1"},
           {"conaffinity", "1"},
           {"condim", "3"},
           {"group", "0"},
           {"priority", "0"},
           {"margin", "0"},
           {"gap", "0"},
           // The others are of friction that condim 3 does not have.
           {"friction", NumberText(physics.friction) + " 0.005 0.0001"}}};
}

/// In a world of the user's the joint has no range, which the compiler would
/// take for degrees or radians as the world says. A tendon of nothing but the
/// joint has its length in radians in any world.
XmlElement JointDefaults(const ServoOptions& servo, Surroundings surroundings) {
  XmlElement joint{"joint",
                   {{"type", "hinge"},
                    {"stiffness", "0"},
                    {"damping", "0"},
                    {"frictionloss", "0"},
                    {"armature", "0"},
                    {"margin", "0"}}};
  const bool is_limited = surroundings == Surroundings::kFloor;
  joint.attributes.emplace_back("limited", is_limited ? "true" : "false");
  if (is_limited) joint.attributes.emplace_back("range", Range(servo.range));
  return joint;
}

XmlElement Defaults(const RobotModel& model, Surroundings surroundings) {
  const ServoOptions& servo = model.options.servo;
  const XmlElement tendon{"tendon",
                          {{"limited", "true"},
                           {"range", Range(servo.range)},
                           {"stiffness", "0"},
                           {"damping", "0"},
                           {"frictionloss", "0"},
                           {"margin", "0"}}};
  XmlElement ours{"default",
                  {{"class", ClassOf(model)}},
                  {GeomDefaults(model.options.physics),
                   JointDefaults(servo, surroundings)}};
  if (surroundings == Surroundings::kNone) ours.children.push_back(tendon);
  ours.children.push_back({"velocity",
                           {{"kv", NumberText(MotorGain(servo))},
                            {"gear", "1"},
                            {"ctrllimited", "true"},
                            {"ctrlrange", Range(servo.max_speed)},
                            {"forcelimited", "true"},
                            {"forcerange", Range(servo.max_torque)}}});
  return {"default", {}, {std::move(ours)}};
}

/// Limits of joints in a world of the user's.
XmlElement Limits(const RobotModel& model) {
  XmlElement tendon{"tendon"};
  for (const std::string& joint : model.joints)
    tendon.children.push_back(
        {"fixed",
         {{"name", joint + "_limit"}, {"class", ClassOf(model)}},
         {{"joint", {{"joint", joint}, {"coef", "1"}}}}});
  return tendon;
}

/// Links that share a hinge, as in our simulation.
XmlElement Excluded(const RobotModel& model) {
  XmlElement contact{"contact"};
  for (const Hinge& hinge : model.assembly.hinges)
    contact.children.push_back(
        {"exclude",
         {{"body1", model.links[static_cast<std::size_t>(hinge.parent)]},
          {"body2", model.links[static_cast<std::size_t>(hinge.child)]}}});
  return contact;
}

XmlElement Actuators(const RobotModel& model) {
  XmlElement actuator{"actuator"};
  for (std::size_t i = 0; i < model.joints.size(); ++i)
    actuator.children.push_back({"velocity",
                                 {{"name", model.servos[i]},
                                  {"class", ClassOf(model)},
                                  {"joint", model.joints[i]}}});
  return actuator;
}

XmlElement Sensors(const RobotModel& model) {
  XmlElement sensor{
      "sensor",
      {},
      {{"accelerometer",
        {{"name", model.imu + "_acceleration"}, {"site", model.imu}}},
       {"gyro", {{"name", model.imu + "_spin"}, {"site", model.imu}}}}};
  for (const TouchSensor& touch : model.touch_sensors)
    sensor.children.push_back(
        {"touch", {{"name", touch.name}, {"site", touch.name}}});
  for (const std::string& joint : model.joints)
    sensor.children.push_back(
        {"jointpos", {{"name", joint + "_angle"}, {"joint", joint}}});
  return sensor;
}

XmlElement Core(const RobotModel& model) {
  XmlElement core{"body",
                  {{"name", model.links[0]}, {"childclass", ClassOf(model)}}};
  AddPose(model.start.position, model.start.axes, core.attributes);
  core.children.push_back({"freejoint", {{"name", model.prefix + "root"}}});
  // Of no mass and no contact; the sensors' frame.
  core.children.push_back(
      {"site", {{"name", model.imu}, {"type", "sphere"}, {"size", "0.005"}}});
  FillBody(model, 0, core);
  return core;
}

/// Implicit, as the stiff motors ask for; the step is ours.
XmlElement Options(const PhysicsOptions& physics) {
  return {"option",
          {{"timestep", NumberText(physics.step)},
           {"gravity", "0 0 " + NumberText(-physics.gravity)},
           {"integrator", "implicit"}}};
}

}  // namespace

std::string Mjcf(const RobotModel& model, Surroundings surroundings) {
  const bool has_floor = surroundings == Surroundings::kFloor;
  XmlElement root{"mujoco",
                  {{"model", model.name + " in " + model.environment}}};
  auto& parts = root.children;
  parts.push_back(XmlComment(NotesOn(model) + "\n" + kMjcfNotes +
                             (has_floor ? "" : kAloneNotes)));
  XmlElement world{"worldbody"};
  if (has_floor) {
    parts.push_back({"compiler", {{"angle", "radian"}}});
    parts.push_back(Options(model.options.physics));
    MjcfGround ground = GroundInMjcf(model);
    if (ground.asset) parts.push_back(std::move(*ground.asset));
    world.children = std::move(ground.geoms);
  }
  parts.push_back(Defaults(model, surroundings));
  world.children.push_back(Core(model));
  parts.push_back(std::move(world));
  if (!model.joints.empty()) {
    parts.push_back(Excluded(model));
    if (!has_floor) parts.push_back(Limits(model));
    parts.push_back(Actuators(model));
  }
  parts.push_back(Sensors(model));
  return PrintXml(root);
}

}  // namespace plsc
