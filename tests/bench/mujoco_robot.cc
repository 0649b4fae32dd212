#include "tests/bench/mujoco_robot.h"

#include <fmt/core.h>
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace plsc::bench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::string Numbers(const Vector3d& v) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
}

std::string Quaternion(const Matrix3d& axes) {
  const Eigen::Quaterniond q(axes);
  return fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}", q.w(), q.x(), q.y(),
                     q.z());
}

/// The link's mass and boxes, without what it carries.
std::string MatterOf(const Link& link) {
  const Matrix3d& i = link.inertia;
  std::string text = fmt::format(
      "<inertial pos='0 0 0' mass='{:.17g}' fullinertia='{:.17g} {:.17g} "
      "{:.17g} {:.17g} {:.17g} {:.17g}'/>\n",
      link.mass, i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2));
  for (const Box& box : link.boxes)
    text += fmt::format("<geom type='box' pos='{}' quat='{}' size='{}'/>\n",
                        Numbers(box.centre - link.centre), Quaternion(box.axes),
                        Numbers(box.size / 2));
  return text;
}

/// The link that hinge `index` moves, and all it carries.
std::string LimbOf(const Assembly& assembly, std::size_t index) {
  const Hinge& hinge = assembly.hinges[index];
  const Link& parent = assembly.links[static_cast<std::size_t>(hinge.parent)];
  const Link& link = assembly.links[static_cast<std::size_t>(hinge.child)];
  std::string text = fmt::format(
      "<body pos='{}'>\n<joint name='j{}' pos='{}' axis='{}'/>\n{}",
      Numbers(link.centre - parent.centre), index,
      Numbers(hinge.anchor - link.centre), Numbers(hinge.axis), MatterOf(link));
  for (std::size_t i = 0; i < assembly.hinges.size(); ++i)
    if (assembly.hinges[i].parent == hinge.child) text += LimbOf(assembly, i);
  return text + "</body>\n";
}

std::string OptionsOf(const SimulationOptions& options) {
  const ServoOptions& servo = options.servo;
  return fmt::format(
      "<compiler angle='radian'/>\n"
      "<option timestep='{}' gravity='0 0 {}' solver='Newton' "
      "cone='pyramidal' integrator='Euler'/>\n"
      "<default>\n<geom condim='3' friction='{} 0.005 0.0001'/>\n"
      "<joint type='hinge' limited='true' range='{} {}' damping='{}'/>\n"
      "<motor gear='{}'/>\n</default>\n",
      options.physics.step, -options.physics.gravity, options.physics.friction,
      -servo.range, servo.range, servo.max_torque / servo.max_speed,
      servo.max_torque / servo.max_speed);
}

}  // namespace

std::string MjcfOf(const Assembly& assembly, const Terrain& terrain,
                   const SimulationOptions& options,
                   const Placement& placement) {
  const Link& core = assembly.links.front();
  const double tilt = terrain.type == TerrainType::kTilted ? terrain.tilt : 0;
  const Matrix3d slope =
      Eigen::AngleAxisd(tilt, Vector3d::UnitX()).toRotationMatrix();
  std::string text = "<mujoco>\n" + OptionsOf(options);
  text += fmt::format(
      "<worldbody>\n<geom type='plane' size='0 0 1' quat='{}'/>\n"
      "<body pos='{}' quat='{}'>\n<freejoint/>\n{}",
      Quaternion(slope), Numbers(placement(core.centre)),
      Quaternion(placement.axes), MatterOf(core));
  for (std::size_t i = 0; i < assembly.hinges.size(); ++i)
    if (assembly.hinges[i].parent == 0) text += LimbOf(assembly, i);
  text += "</body>\n</worldbody>\n<actuator>\n";
  for (std::size_t i = 0; i < assembly.hinges.size(); ++i)
    text += fmt::format("<motor joint='j{}'/>\n", i);
  return text + "</actuator>\n</mujoco>\n";
}

struct MujocoRobot::Parts {
  mjModel* model = nullptr;
  mjData* data = nullptr;
  std::vector<int> angles;  ///< of joints, in mjData::qpos
};

MujocoRobot::MujocoRobot(const std::string& mjcf)
    : parts_(std::make_unique<Parts>()) {
  const auto files = std::make_unique<mjVFS>();  // too large for the stack
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "robot.xml", static_cast<int>(mjcf.size()));
  std::memcpy(files->filedata[0], mjcf.data(), mjcf.size());
  std::array<char, 1000> error = {};
  parts_->model =
      mj_loadXML("robot.xml", files.get(), error.data(), error.size());
  mj_deleteVFS(files.get());
  if (parts_->model == nullptr) throw std::runtime_error(error.data());
  parts_->data = mj_makeData(parts_->model);
  for (int i = 0; i < parts_->model->nu; ++i) {
    const int id =
        mj_name2id(parts_->model, mjOBJ_JOINT, fmt::format("j{}", i).c_str());
    parts_->angles.push_back(parts_->model->jnt_qposadr[id]);
  }
}

MujocoRobot::~MujocoRobot() {
  mj_deleteData(parts_->data);
  mj_deleteModel(parts_->model);
}

int MujocoRobot::joints() const {
  return parts_->model->nu;
}

void MujocoRobot::SetJointSpeed(int joint, double speed) {
  parts_->data->ctrl[joint] = speed;
}

double MujocoRobot::JointAngle(int joint) const {
  return parts_->data->qpos[parts_->angles[static_cast<std::size_t>(joint)]];
}

void MujocoRobot::Step() {
  mj_step(parts_->model, parts_->data);
}

int MujocoRobot::contacts() const {
  return parts_->data->ncon;
}

}  // namespace plsc::bench
