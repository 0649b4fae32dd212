#include "runtime/cli/robots/robot_setting.h"

#include <catch2/catch.hpp>
#include <sstream>

#include "runtime/scenario/scenario_profile.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

/// What a command would find, and what it is told.
struct Found {
  std::istringstream in{test::kPlasticText};
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{in, out, err};

  cli::RobotFound Robot(const cli::RobotAsked& asked) {
    auto found = cli::FindRobot(asked, io);
    INFO(err.str());
    REQUIRE(found);
    return std::move(*found);
  }
};

constexpr const char* kScenario = R"(plsc_scenario: 1
lives: continuous
controller: open_loop
physics: {gravity: 3 m/s2}
servo: {gain: 2 1/s}
seasons:
  - {name: stones, terrain: obstacles, duration: 1 s, start_height: 9 cm}
  - {name: hill, terrain: {tilted: 20 deg}, duration: 2 s, start_height: 9 cm,
     physics: {friction: 0.5}}
)";

TEST_CASE("A robot of a file lives on flat ground", "[robot_setting]") {
  Found found;
  const auto settings =
      cli::SettingsOf(found.Robot({"-", "", {}, false}), found.io);
  REQUIRE(settings.size() == 2);
  const SimulationOptions usual = OptionsFor(
      ProfileScenario(Profile::kPaper), ProfileSeason(Profile::kPaper, {}));
  for (const cli::RobotSetting& one : settings) {
    CHECK(one.terrain == Terrain{});
    CHECK(one.options.physics == usual.physics);
    CHECK(one.options.servo == usual.servo);
  }
  CHECK(found.err.str().empty());
}

TEST_CASE("Every season has its ground and its constants", "[robot_setting]") {
  const test::TemporaryFolder folder;
  const std::string scenario = folder.Write("s.yaml", kScenario);
  Found found;
  const cli::RobotFound robot = found.Robot({"-", "", {}, false, scenario});
  REQUIRE(robot.environments.size() == 2);
  CHECK(robot.environments[0].name == "stones");
  CHECK(robot.environments[1].environment == Environment{{1}});
  const auto settings = cli::SettingsOf(robot, found.io);
  CHECK(settings[0].terrain.type == TerrainType::kObstacles);
  CHECK(settings[0].options.start_height == 0.09);
  CHECK(settings[0].options.physics.gravity == 3);
  CHECK(settings[0].options.servo.gain == 2);
  CHECK(settings[0].options.controller == ControllerMode::kOpenLoop);
  CHECK(settings[1].terrain.type == TerrainType::kTilted);
  CHECK(settings[1].options.physics.friction == 0.5);
  CHECK(settings[1].options.physics.gravity == 3);
  CHECK(settings[1].options.duration == 2);
  CHECK_FALSE(settings[1].options.start_height);  // it lives on
  CHECK(found.err.str().empty());
}

TEST_CASE("An environment is the season that feels so, or flat ground",
          "[robot_setting]") {
  const test::TemporaryFolder folder;
  const std::string scenario = folder.Write(
      "s.yaml",
      "plsc_scenario: 1\nphysics: {gravity: 3 m/s2}\nseasons:\n"
      "  - {name: hill, terrain: {tilted: 20 deg}, duration: 1 s}\n");
  Found found;
  const auto settings = cli::SettingsOf(
      found.Robot(
          {"-", "", {"inclined=True", "inclined=False"}, false, scenario}),
      found.io);
  REQUIRE(settings.size() == 2);
  CHECK(settings[0].terrain.type == TerrainType::kTilted);
  CHECK(settings[1].terrain.type == TerrainType::kFlat);
  CHECK(settings[1].options.physics.gravity == 3);
  CHECK(found.err.str() ==
        "warning: 'inclined=False' is no season: written on flat ground, with "
        "the physics of season 'hill'\n");
}

}  // namespace
}  // namespace plsc
