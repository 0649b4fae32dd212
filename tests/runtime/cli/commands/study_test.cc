// Real studies, tiny: two robots, two generations, seasons of a second.
// study_processes_test.py has what takes several processes.

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::RunPlsc;

const char* const kStudy = R"(plsc_study: 1
name: tiny
seed: 3
repetitions: 2
base:
  population: 2
  offspring: 2
  generations: 2
  scenario:
    seasons: [{name: flat, terrain: flat, duration: 1 s}]
experiments:
  plastic: {}
  baseline: {encoding: baseline}
)";

std::vector<Json> Lines(const std::string& text) {
  std::vector<Json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(Json::parse(line));
  return lines;
}

bool Has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("study list shows what would run, and runs nothing", "[study]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("study.yaml", kStudy);
  const auto ran = RunPlsc({"study", "list", file});
  CHECK(ran.exit == 0);
  CHECK(Has(ran.out, "plastic/1"));
  CHECK(Has(ran.out, "baseline/2"));
  CHECK(Has(ran.out, "4 runs, 16 evaluations\n"));
  CHECK(folder.Files() == std::vector<std::string>{"study.yaml"});

  const auto all =
      Lines(RunPlsc({"study", "list", file, "--format", "json"}).out);
  REQUIRE(all.size() == 4);
  CHECK(all[2]["experiment"] == "baseline");
  CHECK(all[2]["repetition"] == 1);
  CHECK(all[2]["seed"].get<std::string>() != all[0]["seed"].get<std::string>());
  const auto part = Lines(
      RunPlsc({"study", "list", file, "--shard", "2/3", "--format", "json"})
          .out);
  REQUIRE(part.size() == 1);
  CHECK(part[0] == all[1]);
}

TEST_CASE("study run does a part, then the rest, then nothing", "[study]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("study.yaml", kStudy);
  const std::string results = folder / "results";
  auto ran =
      RunPlsc({"study", "run", file, "-o", results, "--only", "baseline/2"});
  INFO(ran.err);
  REQUIRE(ran.exit == 0);
  CHECK(ran.out == "1 run: 1 done now, 0 before\n");
  CHECK(Has(ran.err, "baseline/2 begins\n"));
  CHECK(Has(ran.err, "baseline/2 done, 4 evaluations\n"));

  auto status = RunPlsc({"study", "status", results});
  CHECK(status.exit == 0);
  CHECK(Has(status.out, "plastic/1        missing            0/2"));
  CHECK(Has(status.out, "baseline/2       done               2/2"));
  CHECK(Has(status.out,
            "4 runs, 1 done, 3 missing; 4 of 16 evaluations (25 %)\n"));

  ran = RunPlsc({"study", "run", file, "-o", results, "--quiet"});
  CHECK(ran.exit == 0);
  CHECK(ran.out == "4 runs: 3 done now, 1 before\n");
  CHECK(ran.err.empty());
  ran = RunPlsc({"study", "run", file, "-o", results});
  CHECK(ran.exit == 0);
  CHECK(ran.out == "4 runs: 0 done now, 4 before\n");

  const auto runs =
      Lines(RunPlsc({"study", "status", results, "--format", "json"}).out);
  const auto listed =
      Lines(RunPlsc({"study", "list", file, "--format", "json"}).out);
  REQUIRE(runs.size() == 4);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    CHECK(runs[i]["state"] == "done");
    CHECK(runs[i]["evaluations"] == 4);
    CHECK(runs[i]["evaluations_planned"] == 4);
    CHECK(runs[i]["seed"] == listed[i]["seed"]);
    CHECK(runs[i]["worker"].is_null());
    CHECK(runs[i]["best_speed"].contains("flat"));
    // The run is one of `plsc evolve`, and is what that makes of the seed.
    const auto shown = RunPlsc({"show", runs[i]["run"], "best"});
    CHECK(shown.exit == 0);
  }
}

TEST_CASE("a run of a study is the one that evolve makes", "[study]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("study.yaml", kStudy);
  REQUIRE(RunPlsc({"study", "run", file, "-o", folder / "results", "--only",
                   "plastic/2", "--quiet"})
              .exit == 0);
  const auto listed = Lines(RunPlsc({"study", "list", file, "--only",
                                     "plastic/2", "--format", "json"})
                                .out);
  const std::string experiment =
      folder.Write("e.yaml",
                   "population: 2\noffspring: 2\ngenerations: 2\nscenario:\n"
                   "  seasons: [{name: flat, terrain: flat, duration: 1 s}]\n");
  REQUIRE(RunPlsc({"evolve", experiment, "-o", folder / "e.sqlite", "--seed",
                   listed[0]["seed"].get<std::string>(), "--quiet"})
              .exit == 0);
  const auto genotype = [](const std::string& run) {
    return RunPlsc({"show", run, "best", "--genotype"}).out;
  };
  CHECK_FALSE(genotype(folder / "e.sqlite").empty());
  CHECK(genotype(folder / "e.sqlite") ==
        genotype(folder / "results/plastic/2.sqlite"));
}

TEST_CASE("a scenario of its own file is kept with the study", "[study]") {
  const test::TemporaryFolder folder;
  folder.Write("seasons.yaml",
               "seasons: [{name: short, terrain: flat, duration: 1 s}]\n");
  const std::string file = folder.Write(
      "study.yaml",
      "repetitions: 1\nbase: {population: 2, offspring: 1, generations: 1,\n"
      "  scenario: seasons.yaml}\nexperiments: {a: {}}\n");
  REQUIRE(RunPlsc({"study", "run", file, "-o", folder / "results"}).exit == 0);
  CHECK(Has(test::ReadFile(folder / "results/study.yaml"), "name: short"));
  CHECK(RunPlsc({"study", "status", folder / "results"}).exit == 0);
  // The same command again reads the same study.
  CHECK(RunPlsc({"study", "run", file, "-o", folder / "results"}).exit == 0);
}

TEST_CASE("what is wrong with a study is told, and nothing is begun",
          "[study]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("study.yaml", kStudy);
  const std::string wrong =
      folder.Write("wrong.yaml", "experiments: {a: {populaton: 3}}\n");
  struct Row {
    const char* why;
    std::vector<std::string> arguments;
    int exit;
    const char* message;
  };
  const std::vector<Row> rows = {
      {"a mistake in the file",
       {"study", "run", wrong, "-o", folder / "r"},
       1,
       "did you mean 'population'?"},
      {"no such file",
       {"study", "run", folder / "no.yaml", "-o", folder / "r"},
       1,
       "no.yaml"},
      {"an unknown experiment",
       {"study", "run", file, "-o", folder / "r", "--only", "plastik/1"},
       1,
       "did you mean 'plastic'?"},
      {"a repetition too many",
       {"study", "list", file, "--only", "plastic/3"},
       1,
       "'plastic' has repetitions 1 to 2"},
      {"no shard",
       {"study", "run", file, "-o", folder / "r", "--shard", "0/4"},
       2,
       "expected K/N with K of 1 to N, found '0/4'"},
      {"no output", {"study", "run", file}, 2, "--output"},
      {"no command", {"study"}, 2, "see 'plsc study --help'"},
      {"an unknown command",
       {"study", "stauts", folder / "r"},
       2,
       "did you mean 'status'?"},
      {"an unknown option",
       {"study", "run", file, "-o", folder / "r", "--onyl", "a"},
       2,
       "did you mean '--only'?"},
      {"not a study's folder",
       {"study", "status", folder / "nothing"},
       1,
       "is no study's folder"}};
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const auto ran = RunPlsc(row.arguments);
      INFO(ran.err);
      CHECK(ran.exit == row.exit);
      CHECK(Has(ran.err, row.message));
      CHECK(folder.Files() ==
            std::vector<std::string>{"study.yaml", "wrong.yaml"});
    }
  }
}

TEST_CASE("a folder is of one study", "[study]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("study.yaml", kStudy);
  const std::string results = folder / "results";
  REQUIRE(RunPlsc({"study", "run", file, "-o", results, "--only", "plastic/1",
                   "--quiet"})
              .exit == 0);
  std::string changed = kStudy;
  changed.replace(changed.find("offspring: 2"), 12, "offspring: 3");
  const auto ran = RunPlsc(
      {"study", "run", folder.Write("other.yaml", changed), "-o", results});
  CHECK(ran.exit == 1);
  CHECK(Has(ran.err, "is the folder of another study"));
  CHECK(Has(ran.err, "'offspring: 2', and here 'offspring: 3'"));
}

TEST_CASE("a damaged run is shown, and keeps no other from being done",
          "[study]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("study.yaml", kStudy);
  const std::string results = folder / "results";
  REQUIRE(RunPlsc({"study", "run", file, "-o", results, "--only", "plastic/1",
                   "--quiet"})
              .exit == 0);
  std::filesystem::resize_file(folder / "results/plastic/1.sqlite", 100);
  const auto ran = RunPlsc({"study", "run", file, "-o", results, "--quiet"});
  CHECK(ran.exit == 1);
  CHECK(ran.out == "4 runs: 3 done now, 0 before, 1 damaged\n");
  CHECK(Has(ran.err, "plastic/1.sqlite"));
  const auto status = RunPlsc({"study", "status", results});
  CHECK(status.exit == 1);
  CHECK(Has(status.out, "3 done, 1 damaged"));
  CHECK(Has(status.err, "plastic/1.sqlite"));
}

}  // namespace plsc
