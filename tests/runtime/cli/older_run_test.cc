// A run that plsc 0.1.0 made: a store of the first schema, whose scenario knows
// no engine. All commands that read runs take it.

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "runtime/pages/page.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::ReadFile;
using test::RunPlsc;

struct OlderRun {
  OlderRun() : path(folder / "old.sqlite") {
    std::filesystem::copy_file(
        test::InRepository("tests/data/run_schema_1.sqlite"), path);
  }
  test::TemporaryFolder folder;
  std::string path;
};

bool Tells(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_CASE("a run of 0.1.0 is read by every command", "[older_run]") {
  const OlderRun run;
  const std::string before = ReadFile(run.path);
  const auto shown = RunPlsc({"show", run.path, "--verify"});
  INFO(shown.err);
  CHECK(shown.exit == 0);
  CHECK(Tells(shown.out, "by plsc 0.1.0, results 1, ODE "));
  const Json versions = Json::parse(
      RunPlsc({"show", run.path, "--format", "json"}).out)["versions"];
  CHECK(versions["results"] == 1);
  CHECK(Tells(versions["machine"], "x86_64"));
  CHECK(RunPlsc({"show", run.path, "best"}).exit == 0);
  CHECK(RunPlsc({"draw", run.path, "best"}).exit == 0);
  CHECK(RunPlsc({"why", run.path, "best", "--module", "1"}).exit == 0);
  CHECK(RunPlsc({"simulate", run.path, "best"}).exit == 0);
  CHECK(RunPlsc({"export", run.path, "best", "--to", "json", "-o",
                 run.folder / "robots"})
            .exit == 0);
  const std::string lines = RunPlsc({"export", run.path, "--jsonl"}).out;
  const Json head = Json::parse(lines.substr(0, lines.find('\n')))["run"];
  CHECK(head["versions"]["results"] == 1);
  REQUIRE(RunPlsc({"export", run.path, "--csv", run.folder / "csv"}).exit == 0);
  CHECK(Tells(ReadFile(run.folder / "csv/run.csv"), ",machine,results,"));
  CHECK(std::filesystem::exists(run.folder / "csv/results.csv"));
  const auto report = RunPlsc({"report", run.path, "--format", "json"});
  REQUIRE(report.exit == 0);
  CHECK(Json::parse(report.out)["runs"][0]["results"] == 1);
  if (HasPages())
    CHECK(RunPlsc({"view", run.path, "best", "-o", run.folder / "page.html"})
              .exit == 0);
  const auto replayed = RunPlsc({"replay", run.path, "--all"});
  CHECK(Tells(replayed.err, "differences expected"));
  CHECK_FALSE(Tells(replayed.out, "simulation: stored"));
  CHECK(RunPlsc({"replay", run.path, "--engine", "articulated"}).exit == 0);
  CHECK(ReadFile(run.path) == before);
}

TEST_CASE("a run of 0.1.0 is not gone on with", "[older_run]") {
  const OlderRun run;
  const std::string before = ReadFile(run.path);
  const auto refused = RunPlsc({"evolve", "--resume", run.path});
  CHECK(refused.exit == 1);
  CHECK(Tells(refused.err,
              "was made by other arithmetic: its results have "
              "number 1 (plsc 0.1.0), those of this program 2"));
  CHECK(Tells(refused.err, "plsc 0.1.0 goes on with it"));
  CHECK(RunPlsc({"evolve", "--salvage", run.path, "-o", run.folder / "new"})
            .exit == 1);
  CHECK(ReadFile(run.path) == before);
}

TEST_CASE("a run of the articulated engine is of no machine", "[older_run]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write(
      "e.yaml",
      "profile: swift\npopulation: 2\noffspring: 1\ngenerations: 1\n"
      "scenario: {seasons: [{duration: 1 s}]}\n");
  const std::string path = folder / "run.sqlite";
  REQUIRE(RunPlsc({"evolve", file, "-o", path, "--quiet"}).exit == 0);
  CHECK(Tells(RunPlsc({"show", path}).out,
              "results 2, the same on any machine\n"));
  const Json shown =
      Json::parse(RunPlsc({"show", path, "--format", "json"}).out);
  CHECK(shown["versions"]["machine"] == "any");
  CHECK(shown["versions"]["results"] == 2);
}

}  // namespace
}  // namespace plsc
