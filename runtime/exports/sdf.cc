#include "runtime/exports/sdf.h"

#include <cstddef>

#include "runtime/exports/number_text.h"
#include "runtime/exports/xml_text.h"

namespace plsc {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr const char* kNotes =
    "Joints take that speed as the topic\n"
    "/model/NAME OF THE MODEL/joint/NAME OF THE JOINT/cmd_vel.";

XmlElement Number(std::string name, double number) {
  return XmlText(std::move(name), NumberText(number));
}

XmlElement Pose(const Vector3d& position, const Matrix3d& axes) {
  return XmlText("pose",
                 NumbersText(position) + " " +
                     NumbersText(axes.isIdentity(0) ? Vector3d::Zero().eval()
                                                    : FixedAngles(axes)));
}

XmlElement Inertial(const Link& link, const Vector3d& frame) {
  const Matrix3d& i = link.inertia;
  return {"inertial",
          {},
          {Pose(link.centre - frame, Matrix3d::Identity()),
           Number("mass", link.mass),
           {"inertia",
            {},
            {Number("ixx", i(0, 0)), Number("ixy", i(0, 1)),
             Number("ixz", i(0, 2)), Number("iyy", i(1, 1)),
             Number("iyz", i(1, 2)), Number("izz", i(2, 2))}}}};
}

/// Of one of two bodies that meet; who simulates combines both.
struct SurfaceStiffness {
  double kp = 0;  ///< N/m
  double kd = 0;  ///< N s/m
};

XmlElement Surface(const PhysicsOptions& physics,
                   const SurfaceStiffness& stiffness) {
  return {"surface",
          {},
          {{"friction",
            {},
            {{"ode",
              {},
              {Number("mu", physics.friction), Number("mu2", physics.friction),
               Number("slip1", physics.slip), Number("slip2", physics.slip)}}}},
           {"contact",
            {},
            {{"ode",
              {},
              {Number("kp", stiffness.kp), Number("kd", stiffness.kd)}}}}}};
}

XmlElement Coloured(const std::array<double, 3>& colour) {
  const std::string text = NumbersText({colour[0], colour[1], colour[2]});
  return {"material",
          {},
          {XmlText("ambient", text + " 1"), XmlText("diffuse", text + " 1")}};
}

/// A box as it is seen ("visual") or felt ("collision").
XmlElement Shape(const char* kind, const RobotModel& model, const Box& box,
                 const Vector3d& frame) {
  return {kind,
          {{"name", BoxName(model.phenotype.body, box)}},
          {Pose(box.centre - frame, box.axes),
           {"geometry",
            {},
            {{"box", {}, {XmlText("size", NumbersText(box.size))}}}}}};
}

XmlElement Imu() {
  return {"sensor",
          {{"name", kImuName}, {"type", "imu"}},
          {XmlText("always_on", "true")}};
}

XmlElement ContactSensor(const RobotModel& model, const TouchSensor& touch) {
  const Box& box = model.assembly.links[touch.link].boxes[touch.box];
  return {"sensor",
          {{"name", touch.name}, {"type", "contact"}},
          {XmlText("always_on", "true"),
           {"contact",
            {},
            {XmlText("collision", BoxName(model.phenotype.body, box))}}}};
}

XmlElement LinkOf(const RobotModel& model, std::size_t index) {
  const Link& link = model.assembly.links[index];
  const PhysicsOptions& physics = model.options.physics;
  const Vector3d frame = FrameOf(model.assembly, index);
  XmlElement element{
      "link",
      {{"name", model.links[index]}},
      {Pose(frame, Matrix3d::Identity()), Inertial(link, frame)}};
  for (const Box& box : link.boxes) {
    const auto module = static_cast<std::size_t>(box.module);
    XmlElement seen = Shape("visual", model, box, frame);
    seen.children.push_back(
        Coloured(AuthorsColour(model.phenotype.body.modules[module].type)));
    XmlElement felt = Shape("collision", model, box, frame);
    felt.children.push_back(
        Surface(physics, {physics.robot_kp, physics.robot_kd}));
    element.children.push_back(std::move(seen));
    element.children.push_back(std::move(felt));
  }
  if (index == 0) element.children.push_back(Imu());
  for (const TouchSensor& touch : model.touch_sensors)
    if (touch.link == index)
      element.children.push_back(ContactSensor(model, touch));
  return element;
}

/// In the child's frame, where a joint without a pose is.
XmlElement JointOf(const RobotModel& model, std::size_t hinge) {
  const Hinge& one = model.assembly.hinges[hinge];
  const ServoOptions& servo = model.options.servo;
  return {
      "joint",
      {{"name", model.joints[hinge]}, {"type", "revolute"}},
      {XmlText("parent", model.links[static_cast<std::size_t>(one.parent)]),
       XmlText("child", model.links[static_cast<std::size_t>(one.child)]),
       {"axis",
        {},
        {XmlText("xyz", NumbersText(one.axis)),
         {"limit",
          {},
          {Number("lower", -servo.range), Number("upper", servo.range),
           Number("effort", servo.max_torque),
           Number("velocity", servo.max_speed)}},
         {"dynamics", {}, {Number("damping", 0), Number("friction", 0)}}}}}};
}

XmlElement Plugin(const std::string& file, const std::string& name) {
  return {"plugin",
          {{"filename", "gz-sim-" + file + "-system"},
           {"name", "gz::sim::systems::" + name}}};
}

/// Takes speeds, and gives no more than the joint's effort.
XmlElement SpeedCommand(const std::string& joint) {
  XmlElement plugin = Plugin("joint-controller", "JointController");
  plugin.children.push_back(XmlText("joint_name", joint));
  return plugin;
}

XmlElement ModelElement(const RobotModel& model) {
  XmlElement element{"model", {{"name", model.name}}};
  auto& parts = element.children;
  parts.push_back(XmlComment(NotesOn(model) + "\n" + kNotes));
  parts.push_back(Pose(model.start.position, model.start.axes));
  parts.push_back(XmlText("self_collide", "true"));
  for (std::size_t i = 0; i < model.links.size(); ++i)
    parts.push_back(LinkOf(model, i));
  for (std::size_t i = 0; i < model.joints.size(); ++i)
    parts.push_back(JointOf(model, i));
  for (const std::string& joint : model.joints)
    parts.push_back(SpeedCommand(joint));
  return element;
}

XmlElement Ground(const PhysicsOptions& physics) {
  const XmlElement plane{
      "geometry",
      {},
      {{"plane",
        {},
        {XmlText("normal", "0 0 1"), XmlText("size", "100 100")}}}};
  return {
      "model",
      {{"name", "ground"}},
      {XmlText("static", "true"),
       {"link",
        {{"name", "ground"}},
        {{"collision",
          {{"name", "ground"}},
          {plane, Surface(physics, {physics.ground_kp, physics.ground_kd})}},
         {"visual",
          {{"name", "ground"}},
          {plane, Coloured({0.8, 0.85, 0.8})}}}}}};
}

XmlElement WorldElement(const RobotModel& model) {
  const PhysicsOptions& physics = model.options.physics;
  return {
      "world",
      {{"name", "flat"}},
      {{"physics",
        {{"name", "plsc"}, {"type", "ode"}},
        {Number("max_step_size", physics.step), Number("real_time_factor", 1)}},
       XmlText("gravity", "0 0 " + NumberText(-physics.gravity)),
       Plugin("physics", "Physics"),
       Plugin("user-commands", "UserCommands"),
       Plugin("scene-broadcaster", "SceneBroadcaster"),
       Plugin("contact", "Contact"),
       Plugin("imu", "Imu"),
       {"light",
        {{"name", "sun"}, {"type", "directional"}},
        {XmlText("direction", "-0.5 0.1 -0.9")}},
       Ground(physics),
       ModelElement(model)}};
}

}  // namespace

std::string Sdf(const RobotModel& model, Surroundings surroundings) {
  return PrintXml(
      {"sdf",
       {{"version", "1.7"}},
       {surroundings == Surroundings::kFloor ? WorldElement(model)
                                             : ModelElement(model)}});
}

}  // namespace plsc
