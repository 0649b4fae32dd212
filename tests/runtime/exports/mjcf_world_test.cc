// Robots in worlds of their own ground, and in worlds of the user's.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>

#include "runtime/exports/exported_ground.h"
#include "runtime/exports/mjcf.h"
#include "runtime/exports/number_text.h"
#include "sim/height_field.h"
#include "tests/runtime/exports/mujoco_model.h"
#include "tests/runtime/exports/read_robot.h"
#include "tests/sim/bodies.h"

namespace plsc {
namespace {

using Eigen::Vector3d;
using test::Loaded;

/// A servo unlike any other world's.
SimulationOptions Unusual() {
  SimulationOptions options = ExportedOptions();
  options.physics.gravity = 1.62;
  options.physics.friction = 0.3;
  options.physics.step = 0.0025;
  options.servo = {1.0471975511966, 3, 0.8, 0.5, 20, Refresh::kExact};
  return options;
}

RobotModel CrossOn(const Terrain& terrain, const std::string& prefix = "") {
  return ModelOf({"cross", "somewhere", prefix}, WithOscillators(Cross(), 2, 2),
                 Unusual(), terrain);
}

// Defaults and a compiler unlike ours, a free body, and a joint with a motor.
std::string World(const std::string& angle, const std::string& range,
                  const std::string& includes) {
  return "<mujoco><compiler angle='" + angle +
         "'/><option gravity='0 0 -3' timestep='0.001' integrator='implicit'/>"
         "<default><geom friction='0.7 0.01 0.001' condim='4'/>"
         "<joint damping='0.25' armature='0.5'/>"
         "<velocity kv='11' ctrllimited='true' ctrlrange='-9 9'/></default>" +
         includes +
         "<worldbody><geom name='ground' type='plane' size='5 5 1'/>"
         "<body name='ball' pos='3 0 1'><freejoint name='fly'/>"
         "<geom name='shell' size='0.1'/></body>"
         "<body name='arm' pos='-3 0 1'><joint name='elbow' axis='1 0 0' "
         "limited='true' range='" +
         range +
         "'/><geom name='bone' size='0.1'/></body></worldbody>"
         "<actuator><velocity name='drive' joint='elbow'/></actuator></mujoco>";
}

/// All of the foreign parts that a robot's defaults could have changed.
std::vector<double> ForeignNumbers(const Loaded& loaded) {
  const mjModel& model = loaded.model();
  std::vector<double> numbers = {model.opt.gravity[2], model.opt.timestep,
                                 static_cast<double>(model.opt.integrator)};
  for (const char* name : {"shell", "bone", "ground"}) {
    const int geom = loaded.Id(mjOBJ_GEOM, name);
    for (int i = 0; i < 3; ++i)
      numbers.push_back(model.geom_friction[3 * geom + i]);
    numbers.push_back(model.geom_condim[geom]);
  }
  for (const char* name : {"fly", "elbow"}) {
    const int joint = loaded.Id(mjOBJ_JOINT, name);
    const int dof = model.jnt_dofadr[joint];
    for (const double one :
         {static_cast<double>(model.jnt_limited[joint]),
          model.jnt_range[2 * joint], model.jnt_range[2 * joint + 1],
          model.dof_damping[dof], model.dof_armature[dof]})
      numbers.push_back(one);
  }
  const int motor = loaded.Id(mjOBJ_ACTUATOR, "drive");
  for (const double one :
       {model.actuator_gainprm[mjNGAIN * motor],
        model.actuator_ctrlrange[2 * motor],
        static_cast<double>(model.actuator_ctrllimited[motor]),
        static_cast<double>(model.actuator_forcelimited[motor])})
    numbers.push_back(one);
  return numbers;
}

void CheckRobot(const Loaded& loaded, const RobotModel& robot) {
  const mjModel& model = loaded.model();
  const ServoOptions& servo = robot.options.servo;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const int joint = loaded.Id(mjOBJ_JOINT, robot.joints[i]);
    const auto [lower, upper] = test::LimitsOf(model, joint);
    CHECK(lower == Approx(-servo.range).epsilon(1e-12));
    CHECK(upper == Approx(servo.range).epsilon(1e-12));
    CHECK(model.dof_damping[model.jnt_dofadr[joint]] == 0);
    CHECK(model.dof_armature[model.jnt_dofadr[joint]] == 0);
    const int motor = loaded.Id(mjOBJ_ACTUATOR, robot.servos[i]);
    CHECK(model.actuator_trnid[2 * motor] == joint);
    CHECK(model.actuator_forcerange[2 * motor + 1] == servo.max_torque);
    CHECK(model.actuator_ctrlrange[2 * motor + 1] == servo.max_speed);
  }
  for (const Link& link : robot.assembly.links)
    for (const Box& box : link.boxes) {
      const int geom = loaded.Id(mjOBJ_GEOM, BoxName(robot, box));
      CHECK(model.geom_condim[geom] == 3);
      CHECK(model.geom_friction[3 * geom] == robot.options.physics.friction);
    }
  loaded.Id(mjOBJ_SENSOR, robot.imu + "_spin");
}

TEST_CASE("Two robots fit into a world, which stays as it was", "[mjcf]") {
  const RobotModel a = CrossOn({}, "a_");
  RobotModel b = test::ModelOfBody(Cross(), "cross");
  b = ModelOf({"cross", "flat", "b-"}, b.phenotype, ExportedOptions());
  b.start.position.x() = 1;
  const std::map<std::string, std::string> robots = {
      {"a.xml", Mjcf(a, Surroundings::kNone)},
      {"b.xml", Mjcf(b, Surroundings::kNone)}};
  const std::string include = "<include file='a.xml'/><include file='b.xml'/>";
  // The same joint in the units of either compiler.
  const std::vector<std::pair<std::string, std::string>> units = {
      {"degree", "-90 45"},
      {"radian", "-1.5707963267948966 0.7853981633974483"}};
  for (const auto& [angle, range] : units) {
    INFO(angle);
    const Loaded before(World(angle, range, ""));
    Loaded after(World(angle, range, include), robots);
    CHECK(ForeignNumbers(after) == ForeignNumbers(before));
    CheckRobot(after, a);
    CheckRobot(after, b);
    for (int i = 0; i < 20; ++i) after.Step();
    CHECK(after.warnings() == 0);
  }
}

TEST_CASE("A world's own robot and one beside it", "[mjcf]") {
  const RobotModel a = CrossOn({}, "a_");
  RobotModel b = CrossOn({}, "b_");
  b.start.position.x() = 1;
  std::string world = Mjcf(a, Surroundings::kFloor);
  world.insert(world.find("  <worldbody>"), "<include file='b.xml'/>");
  const Loaded both(world, {{"b.xml", Mjcf(b, Surroundings::kNone)}});
  CheckRobot(both, a);
  CheckRobot(both, b);
}

/// With limits of joints, as a world of our own has them.
std::string WithRanges(std::string mjcf, double range) {
  const auto put = [&](const std::string& old, const std::string& text) {
    REQUIRE(mjcf.find(old) != std::string::npos);
    mjcf.replace(mjcf.find(old), old.size(), text);
  };
  const std::string both = "-" + NumberText(range) + " " + NumberText(range);
  put("<default>", "<compiler angle='radian'/><default>");
  put("<tendon limited=\"true\"", "<tendon limited=\"false\"");
  put("limited=\"false\"/>", "limited=\"true\" range=\"" + both + "\"/>");
  return mjcf;
}

TEST_CASE("Limits of a robot alone hold its joints as ranges do", "[mjcf]") {
  const RobotModel cross = CrossOn({});
  const std::string alone = Mjcf(cross, Surroundings::kNone);
  Loaded ours(alone);
  Loaded ranged(WithRanges(alone, cross.options.servo.range));
  double widest = 0;
  for (int i = 0; i < 1000; ++i) {
    for (Loaded* one : {&ours, &ranged}) {
      one->changed().opt.integrator = mjINT_IMPLICIT;
      one->SetControl(0, cross.options.servo.max_speed);
      one->Step();
    }
    // Behind the free joint.
    CHECK(std::abs(ours.data().qpos[7] - ranged.data().qpos[7]) < 1e-9);
    widest = std::max(widest, ours.data().qpos[7]);
  }
  CHECK(widest > cross.options.servo.range);  // the limit was met
}

TEST_CASE("Constants of the run are MuJoCo's", "[mjcf]") {
  const RobotModel cross = CrossOn({});
  const Loaded loaded(Mjcf(cross, Surroundings::kFloor));
  CHECK(loaded.model().opt.gravity[2] == -1.62);
  CHECK(loaded.model().opt.timestep == 0.0025);
  const int floor = loaded.Id(mjOBJ_GEOM, "floor");
  CHECK(loaded.model().geom_friction[3 * floor] == 0.3);
  CheckRobot(loaded, cross);
}

TEST_CASE("A slope is a slope in MuJoCo", "[mjcf]") {
  Terrain hill;
  hill.type = TerrainType::kTilted;
  hill.tilt = 0.2;
  const Loaded loaded(Mjcf(CrossOn(hill), Surroundings::kFloor));
  const int floor = loaded.Id(mjOBJ_GEOM, "floor");
  const Vector3d normal = test::MatrixAt(loaded.data().geom_xmat, floor).col(2);
  // It rises along y.
  CHECK((normal - Vector3d(0, -std::sin(0.2), std::cos(0.2))).norm() < 1e-12);
  // The robot stands on it, aligned with it.
  CHECK(loaded.data().ncon == 0);
  const int core = loaded.Id(mjOBJ_BODY, "core");
  CHECK((test::MatrixAt(loaded.data().xmat, core).col(2) - normal).norm() <
        1e-12);
}

TEST_CASE("Steps and obstacles are boxes in MuJoCo", "[mjcf]") {
  Terrain stairs;
  stairs.type = TerrainType::kSteps;
  stairs.steps = {0.02, 0.4, 3};
  Terrain stones;
  stones.type = TerrainType::kObstacles;
  stones.obstacles.spacing = 0.5;
  for (const Terrain& terrain : {stairs, stones}) {
    const std::vector<StaticBox> boxes = GroundOf(terrain).boxes;
    const Loaded loaded(Mjcf(CrossOn(terrain), Surroundings::kFloor));
    REQUIRE(!boxes.empty());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const int geom = loaded.Id(mjOBJ_GEOM, "box_" + std::to_string(i + 1));
      CHECK(test::VectorAt(loaded.data().geom_xpos, geom)
                .isApprox(boxes[i].centre, 1e-14));
      CHECK(test::VectorAt(loaded.model().geom_size, geom)
                .isApprox(boxes[i].size / 2, 1e-14));
      CHECK(loaded.model().geom_friction[3 * geom] == 0.3);
    }
    CHECK(loaded.data().ncon == 0);
  }
}

/// The heights as they were written, and the file without them: MuJoCo 2 knows
/// height fields, but not their attribute `elevation`.
std::vector<double> TakeElevation(std::string& mjcf) {
  const std::string key = " elevation=\"";
  const std::size_t begin = mjcf.find(key);
  REQUIRE(begin != std::string::npos);
  const std::size_t end = mjcf.find('"', begin + key.size());
  std::istringstream text(
      mjcf.substr(begin + key.size(), end - begin - key.size()));
  mjcf.erase(begin, end + 1 - begin);
  std::vector<double> heights;
  for (double height = 0; text >> height;) heights.push_back(height);
  return heights;
}

/// As MuJoCo 3 does: rows turned round, scaled to 0..1.
void FillField(const std::vector<double>& heights, mjModel& model) {
  const int rows = model.hfield_nrow[0];
  const int columns = model.hfield_ncol[0];
  REQUIRE(heights.size() == static_cast<std::size_t>(rows * columns));
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      model.hfield_data[(rows - 1 - row) * columns + column] =
          static_cast<float>(
              (heights[static_cast<std::size_t>(row * columns + column)] -
               *low) /
              (*high - *low));
}

TEST_CASE("Rough ground is a height field in MuJoCo", "[mjcf]") {
  Terrain hills;
  hills.type = TerrainType::kRough;
  hills.rough = {7, 0.05, 0.4};
  std::string mjcf = Mjcf(CrossOn(hills), Surroundings::kFloor);
  const std::vector<double> heights = TakeElevation(mjcf);
  Loaded loaded(mjcf);
  FillField(heights, loaded.changed());
  loaded.Compute();
  CHECK(loaded.data().ncon == 0);  // it starts above the hills
  const HeightField field(hills.rough);
  // From above, at grid points and between them.
  for (const auto& [x, y] : std::vector<std::pair<double, double>>{
           {0.3, 0.9}, {-1.25, 0.4}, {2.0, -1.7}, {0.77, -0.33}}) {
    const mjtNum from[3] = {x, y, 1};
    const mjtNum down[3] = {0, 0, -1};
    int geom = -1;
    const mjtNum way = mj_ray(&loaded.model(), &loaded.data(), from, down,
                              nullptr, 1, -1, &geom);
    CHECK(loaded.Name(mjOBJ_GEOM, geom) == "hills");
    CHECK(std::abs(1 - way - field.At(x, y).height) < 0.002);
  }
}

}  // namespace
}  // namespace plsc
