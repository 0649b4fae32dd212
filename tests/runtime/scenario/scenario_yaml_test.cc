#include "runtime/scenario/scenario_yaml.h"

#include <catch2/catch.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "runtime/scenario/scenario_profile.h"

namespace plsc {

namespace {

std::string Errors(const std::string& text) {
  const Source source("test.yaml", text);
  const auto scenario = ParseScenario(source);
  return scenario ? "" : Render(scenario.diagnostics(), source, 0);
}

/// Every field differs from its default, but the engine, which an iterative
/// solver decides.
Scenario Unusual() {
  Scenario scenario = PaperScenario();
  scenario.name = "two words: and a colon";
  scenario.profile = Profile::kPublished;
  scenario.lives = Lives::kContinuous;
  scenario.sample_interval = 0.1;
  scenario.start_clearance = 0.002;
  scenario.controller = ControllerMode::kOpenLoop;
  scenario.measured = MeasuredPoint::kCore;
  scenario.sensing = Sensing::kGiven;
  scenario.imu = {0.1, 2};
  scenario.max_steps = 20000;
  scenario.max_links = 30;
  scenario.seasons[1].terrain.tilt = 0.123456789;
  scenario.seasons[1].senses = {{"temperature", "-30.5"}, {"ground", "wet"}};
  scenario.seasons[1].start_height = 0.2;
  scenario.seasons[0].duration = 1.0 / 3;
  PhysicsOptions& physics = scenario.seasons[0].physics;
  physics = {0.003,
             EngineKind::kOde,
             Solver::kIterative,
             17,
             8,
             9.81,
             0.2,
             2e-5,
             0.9,
             0.02,
             8e4,
             1e6 / 7,
             3e6,
             8e4,
             2e-4,
             50,
             1e-6,
             30,
             300,
             0.2};
  scenario.seasons[1].physics = physics;
  scenario.seasons[1].physics.friction = 0.4;
  scenario.servo = {0.5, 1.1, 2.5, 0.2, 10, Refresh::kLate};
  return scenario;
}

}  // namespace

TEST_CASE("A printed scenario reads back equal", "[scenario]") {
  for (const Scenario& scenario : {PaperScenario(), PublishedScenario(),
                                   BothSeasons(Profile::kSwift), Unusual()}) {
    const std::string text = PrintScenario(scenario);
    INFO(text);
    INFO(Errors(text));
    const auto read = ParseScenario(Source("printed", text));
    REQUIRE(read);
    CHECK(*read == scenario);
    CHECK(PrintScenario(*read) == text);
  }
}

TEST_CASE("What is left out has the paper's value", "[scenario]") {
  const auto read = ParseScenario(Source("s",
                                         "name: paper\nseasons:\n"
                                         "  - senses: {hot: False}\n"
                                         "  - terrain: {tilted: 5 deg}\n"
                                         "    senses: {hot: False}\n"));
  REQUIRE(read);
  CHECK(*read == PaperScenario());
}

TEST_CASE("A profile gives what is left out", "[scenario]") {
  const auto read =
      ParseScenario(Source("s",
                           "name: published\nprofile: published\nseasons:\n"
                           "  - senses: {inclined: False, hot: False}\n"
                           "  - terrain: {tilted: 5 deg}\n"
                           "    senses: {inclined: True, hot: False}\n"));
  REQUIRE(read);
  CHECK(*read == PublishedScenario());
}

TEST_CASE("Keys go before the profile, those of a season before all",
          "[scenario]") {
  const auto read = ParseScenario(
      Source("s",
             "profile: published\ncontroller: coupled\nseasons:\n"
             "  - {name: a, terrain: {tilted: 5 deg}}\n"
             "  - {name: b, terrain: {tilted: 5 deg}, start_height: resting,\n"
             "     physics: {step: 1 ms, friction: 0.5}}\n"
             "physics: {step: 5 ms}\n"));
  REQUIRE(read);
  CHECK(read->controller == ControllerMode::kCoupled);
  CHECK(read->measured == MeasuredPoint::kCore);
  // The very default of the other profile, but it was asked for.
  CHECK(read->seasons[0].physics.step == 0.005);
  CHECK(read->seasons[0].physics.solver == Solver::kIterative);
  CHECK(read->seasons[0].start_height == 0.1);
  CHECK(read->seasons[1].physics.step == 0.001);
  CHECK(read->seasons[1].physics.friction == 0.5);
  CHECK_FALSE(read->seasons[1].start_height);
}

TEST_CASE("A text without an engine means ODE, unless its profile says else",
          "[scenario]") {
  const std::string season = "seasons: [{physics: {step: 4 ms}}]\n";
  const auto engine = [](const std::string& text, Profile otherwise) {
    const auto read = ParseScenario(Source("s", text), otherwise);
    REQUIRE(read);
    return read->seasons[0].physics.engine;
  };
  using enum EngineKind;
  CHECK(engine(season, Profile::kPaper) == kOde);
  CHECK(engine(season, Profile::kSwift) == kArticulated);
  CHECK(engine("profile: swift\n" + season, Profile::kPaper) == kArticulated);
  CHECK(engine("profile: paper\n" + season, Profile::kSwift) == kOde);
  CHECK(engine("physics: {engine: ode}\n" + season, Profile::kSwift) == kOde);
  CHECK(engine("profile: swift\nseasons: [{physics: {engine: ode}}]\n",
               Profile::kPaper) == kOde);
}

TEST_CASE("Engines that cannot live the seasons are told with the season",
          "[scenario]") {
  struct Row {
    const char* why;
    std::string text;
    std::vector<std::string> told;  // nothing: it is fine
  };
  const std::string two = "seasons: [{name: a}, {name: b, physics: {";
  const std::vector<Row> rows = {
      {"the same engine", "profile: swift\n" + two + "step: 4 ms}}]\n", {}},
      {"two engines, two lives", two + "engine: articulated}}]\n", {}},
      {"an iterative season of ODE beside one of the other",
       "profile: swift\n" + two + "engine: ode, solver: iterative}}]\n",
       {}},
      {"iterative, in one season of two",
       "profile: swift\n" + two + "solver: iterative}}]\n",
       {"season 'b'", "'solver: iterative'"}},
      {"iterative by its profile",
       "profile: published\nphysics: {engine: articulated}\nseasons:\n"
       "  - {name: a}\n  - {name: b, terrain: {tilted: 5 deg}}\n",
       {"season 'b'", "'solver: iterative'"}},
      {"two engines, one life",
       "lives: continuous\n" + two + "engine: articulated}}]\n",
       {"'a' and 'b'", "lives: continuous"}},
      {"no engine",
       "physics: {engine: articulatd}\nseasons: [{}]\n",
       {"'articulatd'", "did you mean 'articulated'?"}},
      {"no profile",
       "profile: swit\nseasons: [{}]\n",
       {"'swit'", "did you mean 'swift'?"}},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    const std::string errors = Errors(row.text);
    INFO(errors);
    CHECK(errors.empty() == row.told.empty());
    for (const std::string& part : row.told)
      CHECK(errors.find(part) != std::string::npos);
  }
}

TEST_CASE("Seasons that take too many steps are told before they start",
          "[scenario]") {
  CHECK(Errors("seasons: [{duration: 600 min}]\n")
            .find("season 'flat' of 36000 s takes 7200000 steps, more than "
                  "max_steps, 1000000") != std::string::npos);
  CHECK(Errors("seasons: [{duration: 600 min}]\nmax_steps: 7200000\n").empty());
  CHECK(Errors("seasons: [{duration: 0 s}]\n").find("more than 0 s") !=
        std::string::npos);
}

TEST_CASE("Units are understood", "[scenario]") {
  const auto read = ParseScenario(
      Source("s",
             "seasons: [{duration: 2 min, start_height: 3 cm, terrain: "
             "{tilted: 0.25 rad}}]\nsample_interval: 200 ms\nphysics: {step: "
             "5 ms}\nservo: {range: 45 deg}\n"));
  REQUIRE(read);
  CHECK(read->seasons[0].duration == 120);
  CHECK(read->seasons[0].start_height == 0.03);
  CHECK(read->seasons[0].terrain.tilt == 0.25);
  CHECK(read->sample_interval == 0.2);
  CHECK(read->seasons[0].physics.step == 0.005);
  CHECK(read->servo.range == std::numbers::pi / 4);
}

TEST_CASE("Mistakes in a scenario are shown where they are", "[scenario]") {
  struct Row {
    const char* why;
    const char* text;
    std::vector<const char*> parts;
  };
  const std::vector<Row> rows = {
      {"no seasons", "name: a\n", {"error[P5106]: expected the key 'seasons'"}},
      {"none in the list", "seasons: []\n", {"at least one season"}},
      {"a length for a time",
       "seasons: [{duration: 50 m}]\n",
       {"expected a time in s, ms or min, found 'm'", "test.yaml:1:22"}},
      {"an angle without unit",
       "seasons: [{terrain: {tilted: 5}}]\n",
       {"expected an angle with its unit: deg or rad", "write '5 deg'"}},
      {"a wall",
       "seasons: [{terrain: {tilted: 95 deg}}]\n",
       {"at most 89 deg, found 95 deg"}},
      {"tilted without its tilt",
       "seasons: [{terrain: tilted}]\n",
       {"expected the tilt of the ground", "write 'terrain: {tilted: 5 deg}'"}},
      {"an unknown terrain",
       "seasons: [{terrain: flaat}]\n",
       {"expected flat or tilted or rough or steps or obstacles",
        "did you mean 'flat'?"}},
      {"an unknown key of a terrain",
       "seasons: [{terrain: {tiltet: 5 deg}}]\n",
       {"unknown key 'tiltet'", "did you mean 'tilted'?"}},
      {"YAML's spelling of True",
       "seasons: [{senses: {inclined: true}}]\n",
       {"expected True or False, found 'true'", "write 'True', as in a clause",
        "test.yaml:1:31"}},
      {"two seasons of a name",
       "seasons: [{name: a}, {name: a}]\n",
       {"two seasons are called 'a'"}},
      {"two default names", "seasons: [{}, {}]\n", {"two seasons"}},
      {"a name that is a path",
       "seasons: [{name: ../a}]\n",
       {"expected a name of letters, digits, '_', '-' and '.'",
        "test.yaml:1:18"}},
      {"unknown physics",
       "seasons: [{}]\nphysics: {gravitty: 9.8}\n",
       {"unknown key 'gravitty'", "did you mean 'gravity'?"}},
      {"a step of nothing",
       "seasons: [{}]\nphysics: {step: 0}\n",
       {"expected more than 0 s and at most 0.1 s, found 0 s"}},
      {"an unknown solver",
       "seasons: [{}]\nphysics: {solver: exact}\n",
       {"expected direct or iterative, found 'exact'"}},
      {"samples closer than steps",
       "seasons: [{}]\nsample_interval: 1 ms\n",
       {"error[P5108]: samples every 0.001 s are closer than the steps of "
        "season 'flat', 0.005 s",
        "test.yaml:2:18"}},
      {"more samples than memory holds",
       "seasons: [{duration: 300 min}]\nmax_steps: 20000000\n"
       "sample_interval: 1 ms\nphysics: {step: 1 ms}\n",
       {"error[P5108]: samples every 0.001 s are 18000000 of season 'flat', "
        "18000 s, more than 5000000",
        "test.yaml:3:18", "a greater 'sample_interval'"}},
      {"an IMU that never settles",
       "seasons: [{duration: 1 ms}]\nsample_interval: 1 ms\n"
       "physics: {step: 1e-7}\nimu: {settling: 2 s}\n",
       {"error[P5108]: the IMU settles for 2 s, which are 20000000 steps of "
        "season 'flat', more than 1000000",
        "test.yaml:4"}},
      {"samples further apart than a season",
       "seasons: [{duration: 0.1 s}]\n",
       {"samples every 0.2 s are further apart than season 'flat' is long"}},
      {"not a number", "seasons: [{duration: .nan}]\n", {"found '.nan'"}},
      {"all of them at once",
       "seasons:\n  - {duration: x, start_height: y}\ncontroler: open_loop\n",
       {"found 'x'", "found 'y'", "did you mean 'controller'?"}},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const std::string errors = Errors(row.text);
      for (const char* part : row.parts) {
        INFO(errors);
        CHECK(errors.find(part) != std::string::npos);
      }
    }
  }
}

}  // namespace plsc
