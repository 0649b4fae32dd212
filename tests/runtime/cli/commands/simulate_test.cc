#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "runtime/recording/recording_json.h"
#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::InRepository;
using test::RunPlsc;

// Two short seasons, so that a test takes milliseconds.
constexpr const char* kShort = R"(plsc_scenario: 1
name: short
sample_interval: 0.5 s
seasons:
  - {name: flat, terrain: flat, duration: 1 s, senses: {inclined: False}}
  - {name: hill, terrain: {tilted: 5 deg}, duration: 2 s, start_height: 10 cm,
     senses: {inclined: True}}
)";

TEST_CASE("simulate lives each season with the body of its environment",
          "[simulate]") {
  const test::TemporaryFolder folder;
  const std::string scenario = folder.Write("s.yaml", kShort);
  const auto ran =
      RunPlsc({"simulate", "-", "--scenario", scenario, "--format", "json"},
              test::kPlasticText);
  REQUIRE(ran.exit == 0);
  std::istringstream lines(ran.out);
  std::vector<Json> seasons;
  for (std::string line; std::getline(lines, line);)
    seasons.push_back(Json::parse(line));
  REQUIRE(seasons.size() == 2);
  CHECK(seasons[0]["season"] == "flat");
  CHECK(seasons[0]["body_descriptors"]["hinge_count"] == 0);
  CHECK(seasons[0]["fitness"] == -0.1);  // a robot without joints
  CHECK(seasons[1]["season"] == "hill");
  CHECK(seasons[1]["body_descriptors"]["hinge_count"] == 1);
  CHECK(seasons[1]["outcome"] == "completed");
  CHECK(seasons[1]["behaviour"]["head_balance"] > 0.9);

  SECTION("the same bits on every run") {
    CHECK(RunPlsc({"simulate", "-", "--scenario", scenario, "--format", "json"},
                  test::kPlasticText)
              .out == ran.out);
  }
  SECTION("every descriptor on demand") {
    const auto table =
        RunPlsc({"simulate", "-", "--scenario", scenario, "--descriptors"},
                test::kPlasticText);
    CHECK(table.exit == 0);
    for (const char* name : {"head_balance", "absolute_size", "recurrence"})
      CHECK(table.out.find(name) != std::string::npos);
    // Header and two seasons of two lines as below; a blank, a header, 5 + 20
    // + 11.
    CHECK(std::count(table.out.begin(), table.out.end(), '\n') == 6 + 2 + 48);
  }
  SECTION("a table for people") {
    const auto table =
        RunPlsc({"simulate", "-", "--scenario", scenario}, test::kPlasticText);
    CHECK(table.exit == 0);
    CHECK(table.out.find("speed cm/s") != std::string::npos);
    CHECK(std::count(table.out.begin(), table.out.end(), '\n') == 6);
    CHECK(table.out.find("\n  born: inclined=False\n") != std::string::npos);
    CHECK(table.out.find("\n  another body: inclined False -> True\n") !=
          std::string::npos);
  }
}

TEST_CASE("simulate says how far an iterative solver is from converging",
          "[simulate]") {
  const test::TemporaryFolder folder;
  const std::string scenario = folder.Write(
      "s.yaml",
      "seasons:\n"
      "  - {name: direct, duration: 1 s, senses: {inclined: True}}\n"
      "  - {name: few, duration: 1 s, senses: {inclined: True},\n"
      "     physics: {solver: iterative, solver_iterations: 7}}\n"
      "  - {name: still, duration: 1 s, senses: {inclined: False},\n"
      "     physics: {solver: iterative}}\n");
  const auto ran =
      RunPlsc({"simulate", "-", "--scenario", scenario}, test::kPlasticText);
  REQUIRE(ran.exit == 0);
  const std::string told = "  iterative solver, ";
  const std::size_t at = ran.out.find(told);
  REQUIRE(at != std::string::npos);
  CHECK(ran.out.find(told + "7 iterations: half of the joints' speeds are ") ==
        at);
  // Neither of the direct solver nor of a robot without joints.
  CHECK(ran.out.find(told, at + 1) == std::string::npos);
}

TEST_CASE("simulate writes the samples of each season", "[simulate]") {
  const test::TemporaryFolder folder;
  const std::string scenario = folder.Write("s.yaml", kShort);
  const auto ran = RunPlsc({"simulate", "-", "--scenario", scenario,
                            "--trajectory", folder / "samples"},
                           test::kPlasticText);
  REQUIRE(ran.exit == 0);
  const std::string csv =
      test::ReadFile(folder.path() / "samples" / "hill.csv");
  CHECK(csv.find("time,x,y,z") == 0);
  CHECK(csv.find("joint1") != std::string::npos);
  CHECK(test::ReadFile(folder.path() / "samples" / "scenario.yaml")
            .find("profile: paper\n") != std::string::npos);
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 6);  // 0, 0.5 ... 2 s
}

TEST_CASE("simulate records lives and draws them", "[simulate]") {
  const test::TemporaryFolder folder;
  const std::string scenario = folder.Write("s.yaml", kShort);
  const auto run = [&] {
    return RunPlsc({"simulate", "-", "--scenario", scenario, "--record",
                    folder / "r.json", "--svg", folder / "r.svg"},
                   test::kPlasticText);
  };
  const auto ran = run();
  REQUIRE(ran.exit == 0);
  CHECK(folder.Files() ==
        std::vector<std::string>{"r.json", "r.svg", "s.yaml"});
  const std::string text = test::ReadFile(folder / "r.json");
  const auto recording = ParseRecording(Source("r.json", text));
  REQUIRE(recording);
  REQUIRE(recording->seasons.size() == 2);
  CHECK(recording->seasons[0].name == "flat");
  CHECK(recording->seasons[0].motion.samples() == 51);
  CHECK(recording->seasons[1].change == Change::kBody);
  CHECK(recording->seasons[1].body.joints.size() == 1);
  CHECK(recording->seasons[1].motion.samples() == 101);
  CHECK(recording->scenario.find("name: short") != std::string::npos);
  CHECK(test::ReadFile(folder / "r.svg").find(">hill</text>") !=
        std::string::npos);
  // The table is the same as without; files are replaced by the same bits.
  CHECK(ran.out ==
        RunPlsc({"simulate", "-", "--scenario", scenario}, test::kPlasticText)
            .out);
  REQUIRE(run().exit == 0);
  CHECK(test::ReadFile(folder / "r.json") == text);
}

TEST_CASE("simulate says before it begins that it cannot write", "[simulate]") {
  const test::TemporaryFolder folder;
  for (const char* option : {"--record", "--svg"}) {
    for (const std::string& path :
         {folder / "none/r.json", folder.path().string()}) {
      const auto ran =
          RunPlsc({"simulate", "-", option, path}, test::kPlasticText);
      CHECK(ran.exit == 1);
      CHECK(ran.out.empty());
      CHECK(ran.err.find("cannot write '" + path) != std::string::npos);
    }
  }
  CHECK(folder.Files().empty());
}

TEST_CASE("simulate has the descriptors that develop has", "[simulate]") {
  const test::TemporaryFolder folder;
  const std::string scenario = folder.Write("s.yaml", kShort);
  std::istringstream lines(
      RunPlsc({"simulate", InRepository("examples/spider.pls"), "--scenario",
               scenario, "--format", "json"})
          .out);
  const Json developed =
      Json::parse(RunPlsc({"develop", InRepository("examples/spider.pls"),
                           "--format", "json"})
                      .out);
  int seasons = 0;
  for (std::string line; std::getline(lines, line); ++seasons) {
    const Json season = Json::parse(line);
    for (const char* key : {"body_descriptors", "brain_descriptors"}) {
      CHECK(season[key] == developed[key]);
      CHECK(season[key].size() > 10);
    }
    for (const char* name :
         {"velocity", "displacement_velocity", "displacement_velocity_hill",
          "head_balance", "contacts"})
      CHECK(season["behaviour"][name].is_number());
  }
  CHECK(seasons == 2);
}

TEST_CASE("simulate describes nothing that was not there", "[simulate]") {
  const test::TemporaryFolder folder;
  const std::string yaml =
      "lives: continuous\nseasons:\n"
      "  - {name: fast, duration: 1 s, physics: {max_speed: 0.0001 m/s}}\n"
      "  - {name: never, duration: 1 s}\n";
  const auto ran = RunPlsc({"simulate", "-", "--descriptors", "--scenario",
                            folder.Write("s.yaml", yaml)},
                           test::kPlasticText);
  INFO(ran.out);
  CHECK(ran.exit == 0);
  const auto row = [&](const std::string& name) {
    const std::size_t at = ran.out.find("\n" + name + " ") + 1;
    std::istringstream words(ran.out.substr(at + name.size()));
    std::pair<std::string, std::string> values;
    words >> values.first >> values.second;
    return values;
  };
  CHECK(row("head_balance") == std::pair<std::string, std::string>("-", "-"));
  CHECK(row("absolute_size").first != "-");
  CHECK(row("absolute_size").second == "-");
}

TEST_CASE("simulate tells when and why a robot changed, or its life ended",
          "[simulate]") {
  const test::TemporaryFolder folder;
  const std::string yaml =
      "lives: continuous\nseasons:\n"
      "  - {name: flat, duration: 1 s}\n"
      "  - {name: slope, terrain: {tilted: 5 deg}, duration: 1 s}\n"
      "  - {name: fast, duration: 1 s, physics: {max_speed: 0.0001 m/s}}\n"
      "  - {name: never, duration: 1 s}\n";
  const auto ran =
      RunPlsc({"simulate", "-", "--scenario", folder.Write("s.yaml", yaml)},
              test::kPlasticText);
  INFO(ran.out);
  CHECK(ran.exit == 0);
  for (const char* part :
       {"\n  born at 0 s: inclined=False (IMU 0.0 deg)\n",
        "\n  another body at 1 s: inclined False -> True (IMU ",
        "\n  unstable: link 0 moves at ", "more than max_speed, 0.0001 m/s\n",
        "\n  not_reached: the life ended in season 'fast': unstable\n"})
    CHECK(ran.out.find(part) != std::string::npos);
}

TEST_CASE("simulate says what a season does not say", "[simulate]") {
  const test::TemporaryFolder folder;
  const std::string scenario =
      folder.Write("s.yaml",
                   "plsc_scenario: 1\nsensing: given\nseasons:\n"
                   "  - {name: one, senses: {hot: True}}\n");
  const auto ran =
      RunPlsc({"simulate", "-", "--scenario", scenario}, test::kPlasticText);
  CHECK(ran.exit == 1);
  CHECK(ran.out.empty());
  CHECK(ran.err.find("inclined") != std::string::npos);
  CHECK(ran.err.find("one") != std::string::npos);
}

TEST_CASE("simulate points at what is wrong in a scenario", "[simulate]") {
  struct Row {
    const char* why;
    const char* yaml;
    const char* place;
  };
  const std::vector<Row> rows = {
      {"unknown key", "plsc_scenario: 1\nseason: []\n", "s.yaml:2:1"},
      {"wrong unit",
       "plsc_scenario: 1\nseasons:\n  - {name: a, duration: 50 m}\n",
       "s.yaml:3:25"},
      {"not YAML", "plsc_scenario: [1\n", "s.yaml:"},
      {"empty", "", "s.yaml:1:1"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const test::TemporaryFolder folder;
      const auto ran = RunPlsc(
          {"simulate", "-", "--scenario", folder.Write("s.yaml", row.yaml),
           "--trajectory", folder / "out"},
          test::kPlasticText);
      CHECK(ran.exit == 1);
      CHECK(ran.err.find(row.place) != std::string::npos);
      CHECK(folder.Files() == std::vector<std::string>{"s.yaml"});
    }
  }
}

TEST_CASE("simulate lives a run's robot as the run did", "[simulate]") {
  const std::string run = test::FinishedRun().path();
  const auto ran = RunPlsc({"simulate", run, "18", "--format", "json"});
  REQUIRE(ran.exit == 0);
  const Json stored =
      Json::parse(RunPlsc({"show", run, "18", "--format", "json"}).out);
  std::istringstream lines(ran.out);
  std::size_t seasons = 0;
  for (std::string line; std::getline(lines, line); ++seasons)
    CHECK(Json::parse(line)["state_hash"] ==
          stored["seasons"][seasons]["state_hash"]);
  CHECK(seasons == 2);

  SECTION("or elsewhere") {
    const test::TemporaryFolder folder;
    const auto other = RunPlsc(
        {"simulate", run, "18", "--scenario", folder.Write("s.yaml", kShort)});
    CHECK(other.exit == 0);
    CHECK(other.out.find("robot_18 in scenario short") == 0);
  }
  SECTION("and says what is wrong") {
    CHECK(RunPlsc({"simulate", run}).exit == 2);
    CHECK(RunPlsc({"simulate", run}).err.find("which of its robots?") !=
          std::string::npos);
    CHECK(RunPlsc({"simulate", run, "99"}).exit == 1);
    CHECK(RunPlsc({"simulate", "-", "1"}, test::kPlasticText).exit == 1);
  }
}

TEST_CASE("simulate refuses alphabets without bodies", "[simulate]") {
  const auto ran = RunPlsc({"simulate", InRepository("examples/didactic.pls")});
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("no bodies") != std::string::npos);
}

TEST_CASE("the walkers of the examples walk uphill", "[simulate][slow]") {
  // Not how fast, which may change with the physics, but that they do: their
  // comments promise it.
  for (const char* name : {"gecko", "snake", "spider", "climber"}) {
    INFO(name);
    const auto ran = RunPlsc(
        {"simulate", InRepository(std::string("examples/") + name + ".pls"),
         "--format", "json"});
    REQUIRE(ran.exit == 0);
    std::istringstream lines(ran.out);
    for (std::string line; std::getline(lines, line);) {
      const Json season = Json::parse(line);
      CHECK(season["behaviour"]["displacement_velocity_hill"] > 0.003);
    }
  }
}

}  // namespace
}  // namespace plsc
