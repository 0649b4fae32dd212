// --engine of every command that simulates: the scenario as if each season said
// so, where it cannot be, and that what is stored says it.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::ReadFile;
using test::RunPlsc;

constexpr const char* kBothGrounds =
    "seasons:\n"
    "  - {name: flat, duration: 1 s, senses: {inclined: False}}\n"
    "  - {name: hill, terrain: {tilted: 5 deg}, duration: 1 s,\n"
    "     senses: {inclined: True}}\n";

bool Mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string Indented(const std::string& text) {
  std::istringstream lines(text);
  std::string indented;
  for (std::string line; std::getline(lines, line);)
    indented += "  " + line + "\n";
  return indented;
}

std::string ExperimentOf(const std::string& scenario) {
  return "population: 2\noffspring: 2\ngenerations: 1\nscenario:\n" +
         Indented(scenario);
}

std::string StudyOf(const std::string& scenario) {
  return "plsc_study: 1\nrepetitions: 1\nexperiments:\n  one:\n" +
         Indented(Indented(ExperimentOf(scenario)));
}

/// Every command that simulates a scenario, with a file of it.
struct Commands {
  explicit Commands(const std::string& text) {
    const std::string scenario = folder.Write("s.yaml", text);
    const std::string robot = folder.Write("r.pls", test::kPlasticText);
    const std::string experiment = folder.Write("e.yaml", ExperimentOf(text));
    const std::string study = folder.Write("study.yaml", StudyOf(text));
    all = {{"simulate", robot, "--scenario", scenario},
           {"evaluate", "--stdin", "--scenario", scenario},
           {"evolve", experiment, "-o", folder / "run.sqlite", "--quiet"},
           {"study", "run", study, "-o", folder / "study", "--quiet"},
           {"view", robot, "--scenario", scenario, "-o", folder / "p.html"},
           {"export", robot, "--to", "json", "--scenario", scenario, "-o",
            folder / "robots"}};
  }
  test::TemporaryFolder folder;
  std::vector<std::vector<std::string>> all;
};

test::Ran With(std::vector<std::string> command, const std::string& engine) {
  command.insert(command.end(), {"--engine", engine});
  return RunPlsc(command);
}

TEST_CASE("--engine is taken by every command that simulates", "[engine]") {
  const Commands commands(kBothGrounds);
  for (const auto& command : commands.all) {
    INFO(command[0]);
    const auto ran = With(command, "articulated");
    INFO(ran.err);
    CHECK(ran.exit == 0);
    const auto near = With(command, "articlated");
    CHECK(near.exit == 2);
    CHECK(Mentions(near.err,
                   "expected ode|articulated, found 'articlated'; did you "
                   "mean 'articulated'?"));
  }
}

TEST_CASE("--engine says which season it cannot live", "[engine]") {
  const std::string iterative =
      "seasons: [{name: one}, {name: two, physics: {solver: iterative}}]\n";
  const std::string published =
      "profile: published\nseasons: [{name: one, senses: {inclined: False}}, "
      "{name: two, terrain: {tilted: 5 deg}, senses: {inclined: True}}]\n";
  for (const std::string& text : {iterative, published}) {
    const Commands commands(text);
    for (const auto& command : commands.all) {
      INFO(command[0]);
      const auto ran = With(command, "articulated");
      CHECK(ran.exit == 1);
      CHECK(Mentions(ran.err, "error: --engine articulated: season 'two'"));
      CHECK(Mentions(ran.err, "= help: "));
    }
  }
}

TEST_CASE("a run says which engine it was asked for", "[engine]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("e.yaml", ExperimentOf(kBothGrounds));
  const std::string run = folder / "run.sqlite";
  const auto ran =
      RunPlsc({"evolve", file, "-o", run, "--engine", "articulated"});
  INFO(ran.err);
  REQUIRE(ran.exit == 0);
  CHECK_FALSE(Mentions(ran.err, "swift"));
  std::istringstream lines(RunPlsc({"export", run, "--jsonl"}).out);
  std::string line;
  std::getline(lines, line);
  const Json head = Json::parse(line)["run"];
  CHECK(Mentions(head["experiment"], "engine: articulated\n"));
  CHECK(Mentions(head["scenario"], "engine: articulated\n"));
  SECTION("and goes on with no other") {
    const auto resumed =
        RunPlsc({"evolve", "--resume", run, "--engine", "articulated"});
    CHECK(resumed.exit == 2);
    CHECK(Mentions(resumed.err, "nor --engine"));
    const auto other = RunPlsc({"evolve", file, "-o", run, "--or-resume"});
    CHECK(other.exit == 1);
    CHECK(Mentions(other.err, "is a run of another experiment"));
    CHECK(RunPlsc({"evolve", file, "-o", run, "--or-resume", "--engine",
                   "articulated"})
              .exit == 0);
    const auto salvaged = RunPlsc(
        {"evolve", "--salvage", run, "-o", folder / "new", "--engine", "ode"});
    CHECK(salvaged.exit == 2);
    CHECK(Mentions(salvaged.err, "nor --engine"));
  }
  SECTION("and is the one of a written key") {
    const std::string written = ExperimentOf(
        "physics: {engine: articulated}\n" + std::string(kBothGrounds));
    CHECK(RunPlsc({"evolve", folder.Write("w.yaml", written), "-o", run,
                   "--or-resume"})
              .exit == 0);
  }
}

TEST_CASE("ODE's runs mention once that there is a faster engine", "[engine]") {
  struct Row {
    const char* why;
    std::string scenario;
    std::vector<std::string> more;
    bool is_mentioned;
  };
  const std::string swift = "profile: swift\n";
  const std::string iterative = "physics: {solver: iterative}\n";
  const std::vector<Row> rows = {
      {"ODE", kBothGrounds, {}, true},
      {"the other engine", swift + kBothGrounds, {}, false},
      {"asked for", kBothGrounds, {"--engine", "ode"}, false},
      {"quiet", kBothGrounds, {"--quiet"}, false},
      {"what the other cannot live", iterative + kBothGrounds, {}, false},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    const test::TemporaryFolder folder;
    std::vector<std::string> evolve = {
        "evolve",   folder.Write("e.yaml", ExperimentOf(row.scenario)),
        "-o",       folder / "run.sqlite",
        "--format", "json"};
    std::vector<std::string> study = {
        "study", "run", folder.Write("s.yaml", StudyOf(row.scenario)), "-o",
        folder / "study"};
    for (auto* command : {&evolve, &study}) {
      command->insert(command->end(), row.more.begin(), row.more.end());
      const auto ran = RunPlsc(*command);
      INFO(ran.err);
      CHECK(ran.exit == 0);
      const std::size_t first = ran.err.find("swift");
      CHECK((first != std::string::npos) == row.is_mentioned);
      if (row.is_mentioned)
        CHECK(ran.err.find("swift", first + 1) == std::string::npos);
      CHECK_FALSE(Mentions(ran.out, "swift"));
    }
  }
}

TEST_CASE("what shows a life tells its engine", "[engine]") {
  const Commands commands(kBothGrounds);
  const auto simulated = With(commands.all[0], "articulated");
  CHECK(Mentions(simulated.out, "(profile paper, engine articulated)\n"));
  CHECK(Mentions(RunPlsc(commands.all[0]).out, "(profile paper)\n"));
  for (const char* engine : {"ode", "articulated"}) {
    const auto json_of = [&](const std::vector<std::string>& more) {
      std::vector<std::string> arguments = {"export", "-",    "--env",
                                            "flat",   "--to", "json"};
      arguments.insert(arguments.end(), more.begin(), more.end());
      arguments.insert(arguments.end(), {"--engine", engine});
      const auto ran = RunPlsc(arguments, test::kPlasticText);
      INFO(ran.err);
      REQUIRE(ran.exit == 0);
      return Json::parse(ran.out);
    };
    CHECK(json_of({})["physics"]["engine"] == engine);
    CHECK(json_of({"--scenario",
                   commands.folder / "s.yaml"})["physics"]["engine"] == engine);
  }
  const auto alone = RunPlsc({"export", "-", "--engine", "ode"});
  CHECK(alone.exit == 2);
  // Recordings are what they are; a run's robot lives anew, without a warning
  // that it came out otherwise.
  const auto page =
      RunPlsc({"view", test::FinishedRun().path(), "best", "--engine",
               "articulated", "-o", commands.folder / "run.html"});
  CHECK(page.exit == 0);
  CHECK_FALSE(Mentions(page.err, "warning"));
}

}  // namespace
}  // namespace plsc
