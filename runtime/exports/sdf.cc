#include "runtime/exports/sdf.h"

#include <cstddef>

#include "runtime/exports/exported_ground.h"
#include "runtime/exports/number_text.h"
#include "runtime/exports/robot_model.h"
#include "runtime/scenario/scenario_terrain.h"
#include "runtime/text/xml.h"
#include "sim/ground.h"

namespace plsc {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr const char* kSdfNotes =
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

XmlElement SdfInertial(const Link& link, const Vector3d& frame) {
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
          {{"name", BoxName(model, box)}},
          {Pose(box.centre - frame, box.axes),
           {"geometry",
            {},
            {{"box", {}, {XmlText("size", NumbersText(box.size))}}}}}};
}

XmlElement Imu(const RobotModel& model) {
  return {"sensor",
          {{"name", model.imu}, {"type", "imu"}},
          {XmlText("always_on", "true")}};
}

XmlElement ContactSensor(const RobotModel& model, const TouchSensor& touch) {
  const Box& box = model.assembly.links[touch.link].boxes[touch.box];
  return {"sensor",
          {{"name", touch.name}, {"type", "contact"}},
          {XmlText("always_on", "true"),
           {"contact", {}, {XmlText("collision", BoxName(model, box))}}}};
}

XmlElement LinkOf(const RobotModel& model, std::size_t index) {
  const Link& link = model.assembly.links[index];
  const PhysicsOptions& physics = model.options.physics;
  const Vector3d frame = FrameOf(model.assembly, index);
  XmlElement element{"link",
                     {{"name", model.links[index]}},
                     {Pose(frame, Matrix3d::Identity()),
                      SdfInertial(link, frame),
                      {"velocity_decay",
                       {},
                       {Number("linear", physics.damping),
                        Number("angular", physics.damping)}}}};
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
  if (index == 0) element.children.push_back(Imu(model));
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

/// SDFormat keeps "world" and what stands between two "__" to itself.
std::string NameOf(const RobotModel& model) {
  const std::string& name = model.name;
  const bool is_reserved =
      name == "world" || (name.starts_with("__") && name.ends_with("__"));
  return is_reserved ? "robot_" + name : name;
}

XmlElement ModelElement(const RobotModel& model) {
  XmlElement element{"model", {{"name", NameOf(model)}}};
  auto& parts = element.children;
  parts.push_back(XmlComment(NotesOn(model) + "\n" + kSdfNotes));
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

// No genotype has a hyphen in its name.
constexpr const char* kGroundName = "ground-plane";

/// One shape of the ground, felt and seen.
void AddGround(const std::string& name, const XmlElement& pose,
               const XmlElement& geometry, const PhysicsOptions& physics,
               XmlElement& link) {
  link.children.push_back(
      {"collision",
       {{"name", name}},
       {pose, geometry,
        Surface(physics, {physics.ground_kp, physics.ground_kd})}});
  link.children.push_back({"visual",
                           {{"name", name}},
                           {pose, geometry, Coloured({0.8, 0.85, 0.8})}});
}

/// SDFormat has no height fields but pictures in files of their own: of rough
/// ground only the plane.
XmlElement Ground(const RobotModel& model) {
  const PhysicsOptions& physics = model.options.physics;
  XmlElement link{"link", {{"name", "ground"}}};
  const XmlElement plane{
      "geometry",
      {},
      {{"plane",
        {},
        {XmlText("normal", NumbersText(GroundNormal(model.terrain))),
         XmlText("size", "100 100")}}}};
  const Matrix3d upright = Matrix3d::Identity();
  AddGround("ground", Pose(Vector3d::Zero(), upright), plane, physics, link);
  int number = 0;
  for (const StaticBox& box : GroundOf(model.terrain).boxes)
    AddGround("box_" + std::to_string(++number), Pose(box.centre, upright),
              {"geometry",
               {},
               {{"box", {}, {XmlText("size", NumbersText(box.size))}}}},
              physics, link);
  return {"model",
          {{"name", kGroundName}},
          {XmlText("static", "true"), std::move(link)}};
}

/// ODE's constants, where the engine is ODE. The articulated engine solves the
/// equations of ODE's direct solver, which it is written as.
XmlElement Physics(const PhysicsOptions& physics) {
  const char* solver = physics.solver == Solver::kDirect ? "world" : "quick";
  return {
      "physics",
      {{"name", "plsc"}, {"type", "ode"}},
      {Number("max_step_size", physics.step),
       Number("real_time_factor", 1),
       {"ode",
        {},
        {{"solver",
          {},
          {XmlText("type", solver),
           Number("iters", physics.solver_iterations)}},
         {"constraints",
          {},
          {Number("cfm", physics.world_cfm), Number("erp", physics.world_erp),
           Number("contact_max_correcting_vel", physics.correcting_speed),
           Number("contact_surface_layer", physics.surface_layer)}}}}}};
}

XmlElement WorldElement(const RobotModel& model) {
  const PhysicsOptions& physics = model.options.physics;
  return {"world",
          {{"name", std::string(NameIn(kTerrainNames, model.terrain.type))}},
          {Physics(physics),
           XmlText("gravity", "0 0 " + NumberText(-physics.gravity)),
           Plugin("physics", "Physics"),
           Plugin("user-commands", "UserCommands"),
           Plugin("scene-broadcaster", "SceneBroadcaster"),
           Plugin("contact", "Contact"),
           Plugin("imu", "Imu"),
           {"light",
            {{"name", "sun"}, {"type", "directional"}},
            {XmlText("direction", "-0.5 0.1 -0.9")}},
           Ground(model),
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
