// Robots of a real run live again, by physics. Kills are tested by
// relive_kill_test.py, the file's own rules in tests/runtime/relive.

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "runtime/life/life_plan.h"
#include "runtime/relive/relived_file.h"
#include "runtime/store/database.h"
#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::FinishedRun;
using test::RunPlsc;

struct RelivedCopy {
  test::TemporaryFolder folder;
  std::string run = folder / "1.sqlite";
  RelivedCopy() { std::filesystem::copy_file(FinishedRun().path(), run); }
};

bool IsSaid(const std::string& text, const std::string& part) {
  INFO(text);
  const bool is_said = text.find(part) != std::string::npos;
  CHECK(is_said);
  return is_said;
}

/// Every row of every table, in the order of its key.
std::string Dump(const std::string& path) {
  Database database;
  REQUIRE_FALSE(database.Open(path, Database::Mode::kRead));
  std::string text;
  for (const char* table : {"relived", "program", "season", "robot", "life"}) {
    Statement row(database, std::string("SELECT * FROM ") + table);
    for (row.With(); row.Next(); text += '\n')
      for (int i = 0; i < row.columns(); ++i) text += row.TakeBytes();
  }
  REQUIRE_FALSE(database.TakeFailure());
  return text;
}

TEST_CASE("relive shows what records lose, and leaves the run as it is",
          "[relive]") {
  const RelivedCopy copy;
  const std::string before = test::ReadFile(copy.run);
  const auto ran = RunPlsc({"relive", copy.run, "--lives", "3", "--quiet"});
  CHECK(ran.exit == 0);
  CHECK(ran.err.empty());
  IsSaid(ran.out, "1.sqlite, generation 2: 6 survivors, 3 lives each\n");
  IsSaid(ran.out, "recorded  relived  quartiles");
  IsSaid(ran.out, "with the other season's body and brain, 3 lives each:\n");
  CHECK(test::ReadFile(copy.run) == before);
  CHECK(copy.folder.Files() ==
        std::vector<std::string>{"1.relived.sqlite", "1.sqlite"});
  // What is there is shown again, and nothing is written.
  const std::string lived = test::ReadFile(RelivedPathOf(copy.run));
  CHECK(RunPlsc({"relive", copy.run, "--lives", "3"}).out == ran.out);
  CHECK(test::ReadFile(RelivedPathOf(copy.run)) == lived);
}

TEST_CASE("lives are the same for any workers, and however they were asked for",
          "[relive]") {
  const RelivedCopy one;
  const RelivedCopy many;
  const std::vector<std::string> all = {"--generations", "0,2", "--lives", "3",
                                        "--swap",        "2",   "--quiet"};
  const auto relive = [&](const RelivedCopy& copy,
                          const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"relive", copy.run};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto ran = RunPlsc(arguments);
    INFO(ran.err);
    CHECK(ran.exit == 0);
    return ran.out;
  };
  std::vector<std::string> alone = all;
  alone.insert(alone.end(), {"--jobs", "1"});
  const std::string shown = relive(one, alone);
  relive(many, {"--lives", "1", "--swap", "0", "--jobs", "3", "--quiet"});
  relive(many, {"--lives", "2", "--swap", "1", "--jobs", "2", "--quiet"});
  IsSaid(relive(many, all), "generation 2: 6 survivors, 3 lives each");
  CHECK(relive(many, all).size() > 0);
  CHECK(Dump(RelivedPathOf(many.run)) == Dump(RelivedPathOf(one.run)));
  CHECK(shown.find("generation 0: 6 survivors, 3 lives each") !=
        std::string::npos);
}

// Who is told by the season what it sensed in the other one develops as it did
// there: another way to the same life.
TEST_CASE("a swapped life is that of who is told of the other season",
          "[relive]") {
  const RelivedCopy copy;
  RunPlsc({"relive", copy.run, "--lives", "1", "--swap", "1", "--quiet"});
  RunStore store;
  REQUIRE_FALSE(store.OpenForReading(copy.run));
  RelivedFile file;
  REQUIRE_FALSE(
      file.OpenForReading(RelivedPathOf(copy.run), *IdentityOf(store)));
  const auto lives = file.Lives();
  REQUIRE(lives);
  int swapped = 0;
  for (const RelivedSeason& life : *lives) {
    if (!life.of.is_swapped()) continue;
    ++swapped;
    const auto robot = store.Find(life.of.id);
    REQUIRE(robot);
    Scenario told = store.experiment().scenario;
    const auto season = static_cast<std::size_t>(life.of.season);
    const auto other = static_cast<std::size_t>(life.of.phenotype);
    for (const SensedState& state : robot->evaluation.seasons[other].sensed)
      told.seasons[season].senses[state.name] = state.value;
    Disturbances starts(told.seasons.size());
    starts[season].lift = life.lift;
    const LifePlanner planner(told);
    for (const LifePiece& piece : planner.Plan(robot->genotype, {}, starts))
      if (piece.first == season)
        CHECK(planner.Simulate(robot->genotype, {}, piece, starts)[0]
                  .state_hash == life.state_hash);
  }
  CHECK(swapped > 0);
}

TEST_CASE("relive prints JSON with every measure, and the other engine",
          "[relive]") {
  const RelivedCopy copy;
  const auto ran = RunPlsc({"relive", copy.run, "--lives", "2",
                            "--engine-check", "--format", "json", "--quiet"});
  CHECK(ran.exit == 0);
  const Json json = Json::parse(ran.out);
  CHECK(json["plsc_relived"] == 1);
  const Json& run = json["runs"][0];
  CHECK(run["other_engine"] == "articulated");
  const Json& generation = run["generations"][0];
  CHECK(generation["lives"] == 2);
  CHECK(generation["lives_by_other_engine"] == 2);
  CHECK(generation["measures"].size() == RelivedMeasures().size() * 2);
  CHECK(generation["robots"].size() == 6);
  const Json& best = FinishedRun().summary()["best"];
  CHECK(generation["best"] == best["id"]);
  for (const Json& one : generation["measures"])
    if (one["measure"] == "displacement_velocity_hill") {
      const Json& value = one["best"];
      CHECK(value["lives"].get<int>() <= 2);
      if (value["median"].is_number())
        CHECK(value["lost"].get<double>() ==
              Approx(value["recorded"].get<double>() -
                     value["median"].get<double>()));
      CHECK(one["best_by_other_engine"].is_object());
    }
}

TEST_CASE("the file is of its run, and is not taken for one", "[relive]") {
  const RelivedCopy copy;
  RunPlsc({"relive", copy.run, "--lives", "1", "--quiet"});
  // A folder has one run, and so has what a shell makes of *.sqlite.
  const auto report =
      RunPlsc({"report", copy.folder.path().string(), "--format", "json"});
  CHECK(report.err.empty());
  CHECK(Json::parse(report.out)["runs"].size() == 1);
  const std::string file = RelivedPathOf(copy.run);
  const auto both = RunPlsc({"report", file, copy.run, "--format", "json"});
  CHECK(Json::parse(both.out)["runs"].size() == 1);
  const auto alone = RunPlsc({"show", file});
  CHECK(alone.exit == 1);
  IsSaid(alone.err, "no run itself: name the run");

  std::filesystem::rename(file, copy.folder / "2.relived.sqlite");
  const std::string other = copy.folder / "2.sqlite";
  const auto evolved =
      RunPlsc({"evolve", copy.folder.Write("e.yaml", test::kTinyExperiment),
               "-o", other, "--seed", "99", "--quiet"});
  REQUIRE(evolved.exit == 0);
  const std::string before = test::ReadFile(copy.folder / "2.relived.sqlite");
  const auto refused = RunPlsc({"relive", other, "--lives", "1"});
  CHECK(refused.exit == 1);
  IsSaid(refused.err, "is of another run than '" + other + "'");
  CHECK(test::ReadFile(copy.folder / "2.relived.sqlite") == before);
  const auto warned = RunPlsc({"report", other, "--format", "json"});
  CHECK(warned.exit == 0);
  IsSaid(warned.err, "warning: '" + (copy.folder / "2.relived.sqlite"));
  CHECK(Json::parse(warned.out)["runs"][0]["relived"]["state"] == "unusable");
}

TEST_CASE("a report shows relived values before recorded ones", "[relive]") {
  const RelivedCopy copy;
  const auto without =
      Json::parse(RunPlsc({"report", copy.run, "--format", "json"}).out);
  CHECK(without["relived"]["runs"] == 0);
  CHECK(without["relived"]["command"] == "plsc relive " + copy.run);
  CHECK(without["runs"][0]["relived"]["state"] == "missing");
  const auto ran = RunPlsc(
      {"report", copy.run, "--relive", "2", "--format", "json", "--quiet"});
  CHECK(ran.exit == 0);
  const Json report = Json::parse(ran.out);
  CHECK(report["relived"]["runs"] == 1);
  CHECK(report["relived"]["least_lives"] == 2);
  CHECK(report["finals"][0]["told"] == "relived");
  CHECK(report["runs"][0]["relived"]["speeds"].size() == 2);
  // Without being asked to, it only reads.
  const auto again =
      Json::parse(RunPlsc({"report", copy.run, "--format", "json"}).out);
  CHECK(again["finals"] == report["finals"]);
}

TEST_CASE("relive says what it cannot do", "[relive]") {
  const test::TemporaryFolder folder;
  const std::string run = FinishedRun().path();
  struct Row {
    const char* why;
    std::vector<std::string> arguments;
    int exit;
    const char* said;
  };
  for (const Row& row : std::vector<Row>{
           {"nothing named", {"relive"}, 2, "STUDY|RUN"},
           {"no lives", {"relive", run, "--lives", "0"}, 2, "--lives"},
           {"no such choice",
            {"relive", run, "--generations", "first"},
            2,
            "expected last, all"},
           {"no such generation",
            {"relive", run, "--generations", "7"},
            1,
            "there is no generation 7: 3 are completed, from 0 to 2"},
           {"no such run",
            {"relive", folder / "none.sqlite"},
            1,
            "no such file or folder"},
           {"no run",
            {"relive", test::InRepository("docs/runs.md")},
            1,
            "no SQLite file"}}) {
    DYNAMIC_SECTION(row.why) {
      const auto ran = RunPlsc(row.arguments);
      CHECK(ran.exit == row.exit);
      IsSaid(ran.err, row.said);
      CHECK(ran.out.empty());
    }
  }
}

TEST_CASE("a run of 0.1.0 lives again, and is told to be of other arithmetic",
          "[relive]") {
  const test::TemporaryFolder folder;
  const std::string run = folder / "old.sqlite";
  std::filesystem::copy_file(
      test::InRepository("tests/data/run_schema_1.sqlite"), run);
  const auto ran = RunPlsc({"relive", run, "--lives", "1", "--quiet"});
  CHECK(ran.exit == 0);
  IsSaid(ran.err, "was made by plsc 0.1.0");
  IsSaid(ran.err, "not all that its records lose is luck");
  IsSaid(ran.out, "1 life each");
}

TEST_CASE("in one life nobody is swapped", "[relive]") {
  const test::TemporaryFolder folder;
  const std::string run = folder / "run.sqlite";
  const std::string experiment = folder.Write(
      "e.yaml", std::string(test::kTinyExperiment) + "  lives: continuous\n");
  const auto evolved = RunPlsc({"evolve", experiment, "-o", run, "--quiet"});
  INFO(evolved.err);
  REQUIRE(evolved.exit == 0);
  const auto ran = RunPlsc({"relive", run, "--lives", "2", "--quiet"});
  CHECK(ran.exit == 0);
  IsSaid(ran.out, "2 lives each");
  CHECK(ran.out.find("body and brain") == std::string::npos);
}

}  // namespace
}  // namespace plsc
