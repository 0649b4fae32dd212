#include "runtime/cli/commands/check_file.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::RunPlsc;

TEST_CASE("check knows what it is given", "[check]") {
  struct Row {
    const char* text;
    const char* told;
  };
  const std::vector<Row> rows = {
      {"plsc_experiment: 1\nname: small\npopulation: 4\noffspring: 2\n"
       "generations: 3\n",
       "<stdin>: experiment small, population 4 + 2, 3 generations, 8 robots, "
       "2 seasons, 100 s\n"},
      {"plsc_scenario: 1\nseasons: [{terrain: flat, duration: 5 s}]\n",
       "<stdin>: scenario, 1 season, 5 s\n"},
      {"plsc_study: 1\nname: mine\nrepetitions: 3\nbase: {population: 4, "
       "generations: 1}\nexperiments: {a: {}, b: {}}\n",
       "<stdin>: study mine, 2 experiments, 3 runs each, 24 robots\n"},
      {"{\"plsc_golden\": 1, \"environments\": [{\"environment\": \"a\"}]}",
       "<stdin>: golden file of 1 environment\n"},
  };
  for (const Row& row : rows) {
    CAPTURE(row.text);
    const auto ran = RunPlsc({"check", "-"}, row.text);
    CHECK(ran.err.empty());
    CHECK(ran.out == row.told);
    CHECK(ran.exit == 0);
  }
}

TEST_CASE("check finds every example right", "[check]") {
  for (const char* name : {"climber.pls", "climber.golden.json", "desert.yaml",
                           "life.yaml", "paper_study.yaml", "published.yaml",
                           "small.yaml", "small_study.yaml"}) {
    CAPTURE(name);
    const auto ran =
        RunPlsc({"check", test::InRepository(std::string("examples/") + name)});
    CHECK(ran.exit == 0);
    CHECK(ran.err.empty());
    CHECK(!ran.out.empty());
  }
}

TEST_CASE("check shows the places of errors in YAML, and starts nothing",
          "[check]") {
  const auto ran = RunPlsc({"check", "-", "--format", "json"},
                           "plsc_experiment: 1\nmutation: 80%\nseeds: 1\n");
  CHECK(ran.exit == 1);
  const auto first =
      nlohmann::json::parse(ran.out.substr(0, ran.out.find('\n')));
  CHECK(first["code"] == "P5105");
  CHECK(first["line"] == 2);
  CHECK(first["help"] == "write '0.8'");
}

TEST_CASE("check looks into the scenario that an experiment names", "[check]") {
  const test::TemporaryFolder folder;
  folder.Write("wrong.yaml", "plsc_scenario: 1\nseasons: [{terrain: moon}]\n");
  folder.Write(
      "cold.yaml",
      "plsc_scenario: 1\nsensing: given\nseasons: [{terrain: flat}]\n");
  const auto checked = [&](const std::string& scenario) {
    return RunPlsc({"check", folder.Write("exp.yaml",
                                          "plsc_experiment: 1\n"
                                          "scenario: " +
                                              scenario + "\n")});
  };
  const auto wrong = checked("wrong.yaml");
  CHECK(wrong.exit == 1);
  CHECK(wrong.err.find("wrong.yaml:2:21") != std::string::npos);
  const auto cold = checked("cold.yaml");
  CHECK(cold.exit == 1);
  CHECK(cold.err.find("exp.yaml:2:11") != std::string::npos);
  CHECK(cold.err.find("'inclined'") != std::string::npos);
  const auto missing = checked("missing.yaml");
  CHECK(missing.exit == 1);
  CHECK(missing.err.find("exp.yaml:2:11") != std::string::npos);
  const auto sarif =
      RunPlsc({"check", "--format", "sarif", folder / "exp.yaml"});
  CHECK(nlohmann::json::parse(sarif.out)["runs"][0]["results"].size() == 1);
}

TEST_CASE("check says what to do with a store", "[check]") {
  const auto ran =
      RunPlsc({"check", "-"}, std::string("SQLite format 3\0xyz", 19));
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("plsc show <stdin>") != std::string::npos);
}

}  // namespace
}  // namespace plsc
