#include "runtime/scenario/scenario_profile.h"

#include <cassert>
#include <numbers>

namespace plsc {

namespace {

constexpr double kPaperTilt = 5 * std::numbers::pi / 180;

// m, core's centre above the origin in both seasons. Configured were 0.03 for
// the flat one (plastic_big.py:35-37), but the settings are shared and read
// when a robot is evaluated, so both got the slope's
// (simulator_queue.py:157, plastic_big.py:106-119).
constexpr double kPublishedHeight = 0.1;

}  // namespace

Scenario ProfileScenario(Profile profile) {
  Scenario scenario;  // its defaults are the paper's
  scenario.profile = profile;
  if (profile != Profile::kPublished) return scenario;
  // The connections are never loaded, and would not act if they were
  // (brain_nn.py:119, NeuralNetwork.cpp:276-298 and 332-382).
  scenario.controller = ControllerMode::kOpenLoop;
  scenario.measured = MeasuredPoint::kCore;  // WorldController.cpp:153
  scenario.sensing = Sensing::kGiven;        // plasticoding.py:183-197
  scenario.servo.refresh = Refresh::kLate;   // RobotController.cpp:243
  return scenario;
}

Season ProfileSeason(Profile profile, const Terrain& terrain) {
  Season season;
  season.terrain = terrain;
  if (profile == Profile::kSwift)
    season.physics.engine = EngineKind::kArticulated;
  if (profile != Profile::kPublished) return season;
  season.start_height = kPublishedHeight;
  if (terrain.type == TerrainType::kTilted) {  // tilted5.world
    season.physics.step = 0.003;
    season.physics.solver = Solver::kIterative;
    season.physics.solver_iterations = 50;
  }
  return season;
}

Scenario BothSeasons(Profile profile) {
  Scenario scenario = ProfileScenario(profile);
  Season flat = ProfileSeason(profile, {});
  flat.name = "flat";
  flat.senses = {{"hot", "False"}};
  Terrain slope;
  slope.type = TerrainType::kTilted;
  slope.tilt = kPaperTilt;
  Season tilted = ProfileSeason(profile, slope);
  tilted.name = "tilted";
  tilted.senses = flat.senses;
  if (scenario.sensing == Sensing::kGiven) {
    flat.senses["inclined"] = "False";
    tilted.senses["inclined"] = "True";
  }
  scenario.name = NameIn(kProfileNames, profile);
  scenario.seasons = {flat, tilted};
  return scenario;
}

Scenario PaperScenario() {
  return BothSeasons(Profile::kPaper);
}

Scenario PublishedScenario() {
  return BothSeasons(Profile::kPublished);
}

}  // namespace plsc
