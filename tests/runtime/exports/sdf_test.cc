#include "runtime/exports/sdf.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <sdf/sdf.hh>

#include "runtime/exports/exported_ground.h"
#include "runtime/exports/urdf.h"
#include "tests/runtime/exports/read_robot.h"
#include "tests/sim/bodies.h"

namespace plsc {
namespace {

Eigen::Vector3d ToEigen(const ignition::math::Vector3d& v) {
  return {v.X(), v.Y(), v.Z()};
}

Eigen::Matrix3d ToEigen(const ignition::math::Quaterniond& q) {
  return Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).toRotationMatrix();
}

Eigen::Matrix3d ToEigen(const ignition::math::Matrix3d& m) {
  Eigen::Matrix3d matrix;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      matrix(row, column) =
          m(static_cast<std::size_t>(row), static_cast<std::size_t>(column));
  return matrix;
}

void NoErrors(const sdf::Errors& errors) {
  for (const sdf::Error& error : errors) FAIL_CHECK(error.Message());
}

void ReadSensors(const sdf::Link& link, test::ReadRobot& read) {
  for (std::uint64_t i = 0; i < link.SensorCount(); ++i) {
    const sdf::Sensor& sensor = *link.SensorByIndex(i);
    if (sensor.Type() == sdf::SensorType::IMU) read.has_imu = true;
    if (sensor.Type() != sdf::SensorType::CONTACT) continue;
    read.touch_sensors.push_back(sensor.Name());
    const std::string felt =
        sensor.Element()->GetElement("contact")->Get<std::string>("collision");
    INFO(felt);
    CHECK(link.CollisionByName(felt) != nullptr);
  }
}

test::ReadLink ReadLinkOf(const sdf::Link& link) {
  test::ReadLink read;
  ignition::math::Pose3d frame;
  NoErrors(link.SemanticPose().Resolve(frame, "__model__"));
  const auto& inertial = link.Inertial();
  const ignition::math::Pose3d centre = frame * inertial.Pose();
  const Eigen::Matrix3d axes = ToEigen(centre.Rot());
  read.mass = inertial.MassMatrix().Mass();
  read.centre = ToEigen(centre.Pos());
  read.inertia = axes * ToEigen(inertial.MassMatrix().Moi()) * axes.transpose();
  for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
    const sdf::Collision& one = *link.CollisionByIndex(i);
    ignition::math::Pose3d place;
    NoErrors(one.SemanticPose().Resolve(place, "__model__"));
    REQUIRE(one.Geom()->BoxShape() != nullptr);
    read.boxes[one.Name()] = {ToEigen(place.Pos()), ToEigen(place.Rot()),
                              ToEigen(one.Geom()->BoxShape()->Size())};
  }
  CHECK(link.VisualCount() == link.CollisionCount());
  return read;
}

test::ReadRobot Read(const sdf::Model& model) {
  test::ReadRobot read;
  for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
    const sdf::Link& link = *model.LinkByIndex(i);
    read.links[link.Name()] = ReadLinkOf(link);
    ReadSensors(link, read);
  }
  for (std::uint64_t i = 0; i < model.JointCount(); ++i) {
    const sdf::Joint& joint = *model.JointByIndex(i);
    test::ReadJoint& one = read.joints[joint.Name()];
    one.parent = joint.ParentLinkName();
    one.child = joint.ChildLinkName();
    ignition::math::Pose3d pose;
    NoErrors(joint.SemanticPose().Resolve(pose, "__model__"));
    one.anchor = ToEigen(pose.Pos());
    REQUIRE(joint.Axis(0) != nullptr);
    ignition::math::Vector3d axis;
    NoErrors(joint.Axis(0)->ResolveXyz(axis, "__model__"));
    one.axis = ToEigen(axis);
    one.lower = joint.Axis(0)->Lower();
    one.upper = joint.Axis(0)->Upper();
    one.torque = joint.Axis(0)->Effort();
    one.speed = joint.Axis(0)->MaxVelocity();
  }
  return read;
}

/// The world of a file, or its model if it has none, as long as one lives.
struct ReadFile {
  sdf::Root root;
  const sdf::Model* robot = nullptr;

  explicit ReadFile(const std::string& text) {
    INFO(text);
    NoErrors(root.LoadSdfString(text));
    const sdf::World* world = root.WorldByIndex(0);
    robot = world == nullptr ? root.Model() : world->ModelByIndex(1);
    REQUIRE(robot != nullptr);
  }
};

// libsdformat takes some of these from a name, and reports it.
std::string PlainName(const RobotModel& model) {
  return model.name.find('<') == std::string::npos ? model.name : "plain";
}

void CheckAsWorld(RobotModel model) {
  INFO(model.name);
  model.name = PlainName(model);
  const ReadFile file(Sdf(model, Surroundings::kFloor));
  CHECK(file.robot->Name() == model.name);
  CHECK(file.robot->SelfCollide());
  CHECK((ToEigen(file.robot->RawPose().Pos()) - model.start.position).norm() <
        1e-12);
  CheckIsModel(Read(*file.robot), model);
}

// The reader takes 0.1 s a file, so that the many are slow, and not all of
// them: the odd ones at the beginning, then every fourth.
constexpr std::size_t kFew = 8;

std::vector<RobotModel> Many() {
  constexpr std::size_t kOdd = 4;
  const std::vector<RobotModel>& all = test::ManyModels();
  std::vector<RobotModel> many;
  for (std::size_t i = 0; i < all.size(); i += i < kOdd ? 1 : 4)
    many.push_back(all[i]);
  return many;
}

TEST_CASE("libsdformat reads the robot that plsc simulates", "[sdf]") {
  for (std::size_t i = 0; i < kFew; ++i) CheckAsWorld(test::ManyModels()[i]);
}

TEST_CASE("libsdformat reads many robots that plsc simulates", "[sdf][slow]") {
  for (const RobotModel& model : Many()) CheckAsWorld(model);
}

TEST_CASE("libsdformat reads what the authors' program assembled",
          "[sdf][slow]") {
  int compared = 0;
  for (const test::AuthorsRobot& robot : test::AuthorsRobots()) {
    if (robot.geometry.is_null()) continue;
    ++compared;
    const ReadFile file(Sdf(robot.model, Surroundings::kFloor));
    CheckIsAuthors(Read(*file.robot), robot);
  }
  CHECK(compared == 20);
}

TEST_CASE("The world of an SDFormat file is plsc's", "[sdf]") {
  const RobotModel cross = test::ModelOfBody(Cross(), "cross");
  const PhysicsOptions& physics = cross.options.physics;
  const ReadFile file(Sdf(cross, Surroundings::kFloor));
  const sdf::World& world = *file.root.WorldByIndex(0);
  CHECK(world.ModelCount() == 2);
  CHECK(world.Gravity().Z() == -physics.gravity);
  REQUIRE(world.PhysicsByIndex(0) != nullptr);
  CHECK(world.PhysicsByIndex(0)->MaxStepSize() == physics.step);
  // This reader keeps friction as it was written.
  const auto friction = file.robot->LinkByName("core")
                            ->CollisionByIndex(0)
                            ->Element()
                            ->GetElement("surface")
                            ->GetElement("friction")
                            ->GetElement("ode");
  CHECK(friction->Get<double>("mu") == physics.friction);
  CHECK(friction->Get<double>("mu2") == physics.friction);
  CHECK(friction->Get<double>("slip1") == physics.slip);
  CHECK(friction->Get<double>("slip2") == physics.slip);
}

TEST_CASE("Constants and ground of a season are in an SDFormat file", "[sdf]") {
  SimulationOptions options = ExportedOptions();
  options.physics.gravity = 1.62;
  options.physics.step = 0.0025;
  options.physics.friction = 0.3;
  Terrain hill;
  hill.type = TerrainType::kTilted;
  hill.tilt = 0.2;
  Terrain stairs;
  stairs.type = TerrainType::kSteps;
  stairs.steps = {0.02, 0.4, 3};
  for (const Terrain& terrain : {hill, stairs}) {
    const RobotModel cross =
        ModelOf({"cross", "x"}, {Cross(), {}}, options, terrain);
    const ReadFile file(Sdf(cross, Surroundings::kFloor));
    const sdf::World& world = *file.root.WorldByIndex(0);
    CHECK(world.Gravity().Z() == -1.62);
    CHECK(world.PhysicsByIndex(0)->MaxStepSize() == 0.0025);
    const sdf::Link& ground = *world.ModelByIndex(0)->LinkByIndex(0);
    const sdf::Collision& plane = *ground.CollisionByName("ground");
    const double tilt = terrain.tilt;
    CHECK((ToEigen(plane.Geom()->PlaneShape()->Normal()) -
           Eigen::Vector3d(0, -std::sin(tilt), std::cos(tilt)))
              .norm() < 1e-12);
    CHECK(plane.Element()
              ->GetElement("surface")
              ->GetElement("friction")
              ->GetElement("ode")
              ->Get<double>("mu") == 0.3);
    const auto boxes = GroundOf(terrain).boxes;
    REQUIRE(ground.CollisionCount() == boxes.size() + 1);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const sdf::Collision& box = *ground.CollisionByIndex(i + 1);
      CHECK((ToEigen(box.RawPose().Pos()) - boxes[i].centre).norm() < 1e-12);
      CHECK((ToEigen(box.Geom()->BoxShape()->Size()) - boxes[i].size).norm() <
            1e-12);
    }
  }
}

TEST_CASE("Any name of a genotype is a name of a model", "[sdf]") {
  for (const char* name : {"ground", "world", "__x__", "core", "imu", "flat"}) {
    INFO(name);
    const RobotModel model = test::ModelOfBody(Cross(), name);
    const ReadFile file(Sdf(model, Surroundings::kFloor));
    CHECK(file.robot->Name().ends_with(name));
    CHECK(file.root.WorldByIndex(0)->ModelNameExists(file.robot->Name()));
    CHECK(file.root.WorldByIndex(0)->ModelByIndex(0)->Name() == "ground-plane");
  }
}

TEST_CASE("A robot alone is a model without world", "[sdf]") {
  const RobotModel cross = test::ModelOfBody(Cross(), "cross");
  const ReadFile file(Sdf(cross, Surroundings::kNone));
  CHECK(file.root.WorldCount() == 0);
  CheckIsModel(Read(*file.robot), cross);
}

void CheckAsUrdf(const RobotModel& model) {
  INFO(model.name);
  const ReadFile file(Urdf(model));
  const test::ReadRobot read = Read(*file.robot);
  CHECK(read.links.size() == model.links.size());
  CHECK(read.touch_sensors.size() == model.touch_sensors.size());
  CHECK(read.has_imu);
  for (std::uint64_t i = 0; i < file.robot->LinkCount(); ++i) {
    const sdf::Link& link = *file.robot->LinkByIndex(i);
    for (std::uint64_t k = 0; k < link.CollisionCount(); ++k) {
      const sdf::Collision& one = *link.CollisionByIndex(k);
      INFO(one.Name());
      const auto surface = one.Element()->FindElement("surface");
      REQUIRE(surface);
      CHECK(surface->GetElement("friction")
                ->GetElement("ode")
                ->Get<double>("mu") == model.options.physics.friction);
    }
  }
}

TEST_CASE("Gazebo's reader finds sensors and friction of a URDF", "[sdf]") {
  for (std::size_t i = 0; i < kFew; ++i) CheckAsUrdf(test::ManyModels()[i]);
}

TEST_CASE("Gazebo's reader finds sensors and friction of many URDFs",
          "[sdf][slow]") {
  for (const RobotModel& model : Many()) CheckAsUrdf(model);
}

}  // namespace
}  // namespace plsc
