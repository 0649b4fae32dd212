#include "runtime/exports/mjcf.h"

#include <catch2/catch.hpp>
#include <set>

#include "sim/controller.h"
#include "sim/world.h"
#include "tests/runtime/exports/mujoco_model.h"
#include "tests/runtime/exports/read_robot.h"
#include "tests/sim/bodies.h"

namespace plsc {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::Loaded;
using test::MatrixAt;
using test::VectorAt;

void ReadJoints(const Loaded& loaded, const Vector3d& start,
                test::ReadRobot& read) {
  const mjModel& model = loaded.model();
  REQUIRE(model.nu == model.njnt - 1);
  for (int i = 0; i < model.nu; ++i) {
    const int joint = model.actuator_trnid[2 * i];
    const int child = model.jnt_bodyid[joint];
    test::ReadJoint& one = read.joints[loaded.Name(mjOBJ_JOINT, joint)];
    one.child = loaded.Name(mjOBJ_BODY, child);
    one.parent = loaded.Name(mjOBJ_BODY, model.body_parentid[child]);
    one.anchor = VectorAt(loaded.data().xanchor, joint) - start;
    one.axis = VectorAt(loaded.data().xaxis, joint);
    const auto [lower, upper] = test::LimitsOf(model, joint);
    one.lower = lower;
    one.upper = upper;
    CHECK(model.actuator_forcelimited[i] == 1);
    CHECK(model.actuator_forcerange[2 * i] ==
          -model.actuator_forcerange[2 * i + 1]);
    one.torque = model.actuator_forcerange[2 * i + 1];
    one.speed = model.actuator_ctrlrange[2 * i + 1];
  }
}

void ReadSensors(const Loaded& loaded, test::ReadRobot& read) {
  const mjModel& model = loaded.model();
  bool has_acceleration = false;
  bool has_spin = false;
  for (int i = 0; i < model.nsensor; ++i) {
    has_acceleration |= model.sensor_type[i] == mjSENS_ACCELEROMETER;
    has_spin |= model.sensor_type[i] == mjSENS_GYRO;
    if (model.sensor_type[i] == mjSENS_TOUCH)
      read.touch_sensors.push_back(loaded.Name(mjOBJ_SENSOR, i));
  }
  read.has_imu = has_acceleration && has_spin;
}

test::ReadRobot Read(const Loaded& loaded, const Vector3d& start) {
  const mjModel& model = loaded.model();
  const mjData& data = loaded.data();
  test::ReadRobot read;
  for (int i = 1; i < model.nbody; ++i) {  // 0 is the world
    test::ReadLink& link = read.links[loaded.Name(mjOBJ_BODY, i)];
    const Matrix3d axes = MatrixAt(data.ximat, i);
    link.mass = model.body_mass[i];
    link.centre = VectorAt(data.xipos, i) - start;
    link.inertia =
        axes * VectorAt(model.body_inertia, i).asDiagonal() * axes.transpose();
  }
  for (int i = 0; i < model.ngeom; ++i) {
    if (model.geom_bodyid[i] == 0) continue;
    CHECK(model.geom_type[i] == mjGEOM_BOX);
    read.links[loaded.Name(mjOBJ_BODY, model.geom_bodyid[i])]
        .boxes[loaded.Name(mjOBJ_GEOM, i)] = {
        VectorAt(data.geom_xpos, i) - start, MatrixAt(data.geom_xmat, i),
        2 * VectorAt(model.geom_size, i)};
  }
  ReadJoints(loaded, start, read);
  ReadSensors(loaded, read);
  return read;
}

TEST_CASE("MuJoCo reads the robot that plsc simulates", "[mjcf]") {
  for (const RobotModel& model : test::ManyModels()) {
    INFO(model.name);
    Loaded loaded(Mjcf(model, Surroundings::kFloor));
    CHECK(loaded.model().opt.timestep == model.options.physics.step);
    CHECK(loaded.model().opt.gravity[2] == -model.options.physics.gravity);
    CheckIsModel(Read(loaded, model.start.position), model);
    for (int i = 0; i < 100; ++i) loaded.Step();
    CHECK(loaded.warnings() == 0);
  }
}

TEST_CASE("MuJoCo reads what the authors' program assembled", "[mjcf]") {
  int compared = 0;
  for (const test::AuthorsRobot& robot : test::AuthorsRobots()) {
    if (robot.geometry.is_null()) continue;
    ++compared;
    const Loaded loaded(Mjcf(robot.model, Surroundings::kFloor));
    CheckIsAuthors(Read(loaded, robot.model.start.position), robot);
  }
  CHECK(compared == 20);
}

/// By names of links, a pair once.
std::set<std::pair<std::string, std::string>> Meetings(const Loaded& loaded) {
  std::set<std::pair<std::string, std::string>> pairs;
  for (int i = 0; i < loaded.data().ncon; ++i) {
    const mjContact& contact = loaded.data().contact[i];
    pairs.insert(std::minmax(
        loaded.Name(mjOBJ_BODY, loaded.model().geom_bodyid[contact.geom1]),
        loaded.Name(mjOBJ_BODY, loaded.model().geom_bodyid[contact.geom2])));
  }
  return pairs;
}

TEST_CASE("In MuJoCo robots start above the floor, and joined links pass",
          "[mjcf]") {
  // Joined links overlap at rest: each frame holds part of the servo.
  const RobotModel cross = test::ModelOfBody(Cross(), "cross");
  const Loaded loaded(Mjcf(cross, Surroundings::kFloor));
  CHECK(Meetings(loaded).empty());
  double lowest = 1;
  const auto& model = loaded.model();
  for (int i = 0; i < model.ngeom; ++i) {
    if (model.geom_bodyid[i] == 0) continue;
    const Vector3d reach = MatrixAt(loaded.data().geom_xmat, i).cwiseAbs() *
                           VectorAt(model.geom_size, i);
    lowest = std::min(lowest, loaded.data().geom_xpos[3 * i + 2] - reach.z());
  }
  CHECK(lowest == Approx(cross.options.start_clearance).margin(1e-9));
}

TEST_CASE("A robot alone has no floor, and MuJoCo's own step", "[mjcf]") {
  const RobotModel cross = test::ModelOfBody(Cross(), "cross");
  const Loaded loaded(Mjcf(cross, Surroundings::kNone));
  for (int i = 0; i < loaded.model().ngeom; ++i)
    CHECK(loaded.model().geom_bodyid[i] != 0);
  CheckIsModel(Read(loaded, cross.start.position), cross);
}

TEST_CASE("A touch sensor of MuJoCo feels what its box meets", "[mjcf]") {
  Body sensing = LoneCore();
  Mount(sensing, 0, Slot::kFront, ModuleType::kTouchSensor);
  Mount(sensing, 0, Slot::kBack, ModuleType::kTouchSensor);
  RobotModel standing = test::ModelOfBody(sensing, "standing");
  // Front down: the front sensor bears it all.
  standing.start.axes << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  standing.start.position = {0, 0, 0.052};
  Loaded loaded(Mjcf(standing, Surroundings::kFloor));
  for (int i = 0; i < 40; ++i) loaded.Step();
  const auto& model = loaded.model();
  double front = -1;
  double back = -1;
  for (int i = 0; i < model.nsensor; ++i) {
    const double value = loaded.data().sensordata[model.sensor_adr[i]];
    if (loaded.Name(mjOBJ_SENSOR, i) == "touch_1s1") front = value;
    if (loaded.Name(mjOBJ_SENSOR, i) == "touch_1s0") back = value;
  }
  CHECK(front > 0.5);  // N; it weighs 0.94
  CHECK(back == 0);
}

/// One robot in both engines, driven by our controller.
class Both {
 public:
  explicit Both(const RobotModel& model)
      : model_(model),
        ours_(model.assembly, Terrain{}, model.options),
        theirs_(Mjcf(model, Surroundings::kFloor)),
        controller_(model.phenotype, ControllerMode::kOpenLoop) {}

  void SetSpeeds(double time) {
    const std::vector<bool> touched(model_.phenotype.body.modules.size());
    const auto& outputs = controller_.Update(time, touched);
    for (int joint = 0; joint < ours_.joints(); ++joint) {
      const double output = outputs[static_cast<std::size_t>(joint)];
      const ServoOptions& servo = model_.options.servo;
      ours_.SetJointSpeed(joint,
                          ServoSpeed(output, ours_.JointAngle(joint), servo));
      theirs_.SetControl(joint, ServoSpeed(output, TheirAngle(joint), servo));
    }
  }
  void Step() {
    REQUIRE(ours_.Step());
    theirs_.Step();
  }
  double LargestDifference() const {
    double largest = 0;
    for (int joint = 0; joint < ours_.joints(); ++joint)
      largest = std::max(largest,
                         std::abs(ours_.JointAngle(joint) - TheirAngle(joint)));
    return largest;
  }
  double OurAngle(int joint) const { return ours_.JointAngle(joint); }

 private:
  double TheirAngle(int joint) const {
    const mjModel& model = theirs_.model();
    return theirs_.data()
        .qpos[model.jnt_qposadr[model.actuator_trnid[2 * joint]]];
  }

  const RobotModel& model_;
  World ours_;
  Loaded theirs_;
  Controller controller_;
};

TEST_CASE("Joints turn in MuJoCo as they do in plsc", "[mjcf]") {
  const RobotModel cross = test::ModelOfBody(Cross(), "cross");
  const double step = cross.options.physics.step;
  Both both(cross);
  double largest = 0;
  double widest = 0;
  for (int i = 0; i < 800; ++i) {
    if (i % 25 == 0) both.SetSpeeds(i * step);  // 8 times a second
    both.Step();
    largest = std::max(largest, both.LargestDifference());
    widest = std::max(widest, std::abs(both.OurAngle(0)));
  }
  // rad. Two engines with two ideas of contact; four legs lift the core.
  CHECK(widest > 0.2);
  CHECK(largest < 0.02);
}

}  // namespace
}  // namespace plsc
