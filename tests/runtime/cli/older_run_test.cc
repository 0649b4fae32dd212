// Runs that older programs made. plsc 0.1.0: a store of the first schema, whose
// scenario knows no engine. Schema 2: without servo errors and turns of the
// core, and without a census of each generation. Schema 3: without trials.
// Schema 4: without where robots come to be and what their ways cost. All
// commands that read runs take them.

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
  explicit OlderRun(int schema = 1) : path(folder / "old.sqlite") {
    std::filesystem::copy_file(
        test::InRepository("tests/data/run_schema_" + std::to_string(schema) +
                           ".sqlite"),
        path);
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

TEST_CASE("a run of schema 2 is read, and what it lacks is told",
          "[older_run]") {
  const OlderRun run(2);
  const std::string before = ReadFile(run.path);
  const auto shown = RunPlsc({"show", run.path, "--verify"});
  INFO(shown.err);
  CHECK(shown.exit == 0);
  CHECK(Tells(shown.out, "by plsc 0.2.0, results 2"));
  CHECK(Tells(shown.out, " different genotypes and "));
  const Json json =
      Json::parse(RunPlsc({"show", run.path, "--format", "json"}).out);
  CHECK(json["schema"] == 2);
  CHECK(json["census"]["founders"] == 3);
  const Json best =
      Json::parse(RunPlsc({"show", run.path, "best", "--format", "json"}).out);
  const Json& behaviour = best["seasons"][0]["behaviour"];
  CHECK(behaviour["contacts"].is_number());
  CHECK(behaviour["core_turns"].is_null());
  CHECK(RunPlsc({"draw", run.path, "best"}).exit == 0);
  CHECK(RunPlsc({"why", run.path, "best", "--module", "1"}).exit == 0);
  REQUIRE(RunPlsc({"export", run.path, "--csv", run.folder / "csv"}).exit == 0);
  const std::string results = ReadFile(run.folder / "csv/results.csv");
  CHECK(Tells(results,
              ",contacts,servo_error_median,servo_error_worst,"
              "core_turns,final_x,"));
  CHECK(Tells(results, ",,,,,,,,,,,,,400,"));  // empty cells
  CHECK(Tells(ReadFile(run.folder / "csv/generations.csv"),
              "number,best,genotypes,"));
  CHECK(RunPlsc({"export", run.path, "--jsonl"}).exit == 0);
  CHECK(RunPlsc({"report", run.path, "--format", "json"}).exit == 0);
  if (HasPages())
    CHECK(RunPlsc({"view", run.path, "best", "-o", run.folder / "page.html"})
              .exit == 0);
  // Its arithmetic is this program's: all that it has comes again.
  const auto replayed = RunPlsc({"replay", run.path, "--all"});
  INFO(replayed.out);
  CHECK(replayed.exit == 0);
  CHECK(Tells(replayed.err,
              "is a store of schema 2, without servo_error_median, "
              "servo_error_worst, core_turns, final_x, "));
  CHECK(ReadFile(run.path) == before);
}

TEST_CASE("a run of schema 2 is not gone on with, but made again",
          "[older_run]") {
  const OlderRun run(2);
  const std::string before = ReadFile(run.path);
  const auto refused = RunPlsc({"evolve", "--resume", run.path});
  CHECK(refused.exit == 1);
  CHECK(
      Tells(refused.err, "is a store of schema 2, and this program's have 5"));
  CHECK(Tells(refused.err, "(plsc 0.2.0) goes on with it"));
  CHECK(
      RunPlsc({"evolve", "--resume", run.path, "--allow-other-version"}).exit ==
      1);
  const auto again =
      RunPlsc({"evolve", "--salvage", run.path, "-o", run.folder / "new",
               "--quiet", "--allow-other-version"});
  CHECK(again.exit == 0);
  CHECK(Tells(again.err,
              "is a store of schema 2, whose simulations lack "
              "servo_error_median"));
  const Json one = Json::parse(
      RunPlsc({"show", run.folder / "new", "--format", "json"}).out);
  CHECK(one["schema"] == 5);
  const Json two =
      Json::parse(RunPlsc({"show", run.path, "--format", "json"}).out);
  CHECK(one["census"] == two["census"]);  // kept, and counted afterwards
  CHECK(ReadFile(run.path) == before);
}

TEST_CASE("runs of schema 3 and 4 lack the ends of lives and trials",
          "[older_run]") {
  for (const int schema : {3, 4}) {
    CAPTURE(schema);
    const OlderRun run(schema);
    const std::string before = ReadFile(run.path);
    const auto shown = RunPlsc({"show", run.path, "--verify"});
    INFO(shown.err);
    CHECK(shown.exit == 0);
    CHECK(Tells(shown.out, "lives: ") == (schema == 4));
    CHECK_FALSE(Tells(shown.out, "\nfitness: "));
    const Json json =
        Json::parse(RunPlsc({"show", run.path, "--format", "json"}).out);
    CHECK(json["schema"] == schema);
    CHECK(json["lives"].is_null() == (schema == 3));
    CHECK(Tells(json["fitness"].get<std::string>(), "speed * 0.1"));
    CHECK(Tells(RunPlsc({"show", run.path, "best"}).out, "trials in") ==
          (schema == 4));
    REQUIRE(RunPlsc({"export", run.path, "--csv", run.folder / "csv"}).exit ==
            0);
    const std::string trials = ReadFile(run.folder / "csv/trials.csv");
    CHECK((trials.find('\n') == trials.size() - 1) == (schema == 3));
    CHECK(RunPlsc({"export", run.path, "--jsonl"}).exit == 0);
    const auto report = RunPlsc({"report", run.path, "--format", "json"});
    REQUIRE(report.exit == 0);
    const Json told = Json::parse(report.out);
    CHECK(told["runs"][0]["lacks"].size() == 9);
    CHECK(told["experiments"][0]["fitness"].is_null());
    const auto replayed = RunPlsc({"replay", run.path, "--all"});
    INFO(replayed.out);
    CHECK(replayed.exit == 0);
    CHECK(Tells(replayed.err, "without final_x, "));
    const auto refused = RunPlsc({"evolve", "--resume", run.path});
    CHECK(refused.exit == 1);
    CHECK(Tells(refused.err,
                "and this program's have 5: its lives lack "
                "final_x, "));
    // Made again: the same lives and the same end.
    const auto again = RunPlsc(
        {"evolve", "--salvage", run.path, "-o", run.folder / "new", "--quiet"});
    INFO(again.err);
    CHECK(again.exit == 0);
    CHECK(Tells(again.err, "whose simulations lack final_x"));
    const Json made = Json::parse(
        RunPlsc({"show", run.folder / "new", "--format", "json"}).out);
    CHECK(made["schema"] == 5);
    CHECK(made["census"] == json["census"]);
    CHECK(made["best"] == json["best"]);
    CHECK(ReadFile(run.path) == before);
  }
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
