#include "runtime/report/report_json.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/runtime/report/reported_study.h"

namespace plsc {
namespace {

using nlohmann::json;
using test::ReportedStudy;

json JsonOf(const StudyReport& report) {
  return json::parse(ReportJson(report, ClaimResultsOf(report),
                                {"plsc 1", "2026-01-01T00:00:00Z"}));
}

}  // namespace

TEST_CASE("The JSON of a report has every part of it", "[report_json]") {
  const json report = JsonOf(ReportedStudy::Get().report);
  CHECK(report["plsc_report"] == 3);
  CHECK(report["title"] == "reported");
  CHECK(report["made"]["by"] == "plsc 1");
  CHECK(report["generation"] == 4);
  CHECK(report["single"] == false);
  CHECK(report["measures"][0]["title"] == "Speed");
  CHECK(report["experiments"][0]["encoding"] == "plasticoding");
  CHECK(report["experiments"][3]["static"] == true);
  CHECK(report["experiments"][3]["seasons"][0]["shown_in"] == "tilted");
  CHECK(report["curves"][0]["median"].size() == 5);
  CHECK(report["finals"][0]["values"].size() == 2);
  CHECK(report["finals"][0]["values"][0]["run"] == "plastic/1");
  CHECK(report["tests"][0]["p"].is_number());
  CHECK(report["plasticity"].size() == 2);
  CHECK(report["plasticity"][0]["silent"]["median"].size() == 5);
  CHECK(report["diversity"].size() == 4);
  CHECK(report["diversity"][0]["founders"]["median"][0] == 8);
  REQUIRE(report["servo_errors"].size() == 2 + 2 + 1 + 1);
  CHECK(report["servo_errors"][0]["engine"] == "ode");
  CHECK(report["servo_errors"][0]["solver"] == "direct");
  CHECK(report["servo_errors"][0]["iterations"].is_null());
  CHECK(report["servo_errors"][0]["runs"] == 3);
  REQUIRE(report["regulation"].size() == 1);
  CHECK(report["regulation"][0]["symbols"].size() == 5);
  CHECK(report["constants"].size() == 4);
  CHECK(report["constants"][0]["same"] == true);
}

TEST_CASE("Runs are told with their state, and what there is of them",
          "[report_json]") {
  const json runs = JsonOf(ReportedStudy::Get().report)["runs"];
  REQUIRE(runs.size() == 12);
  CHECK(runs[0]["label"] == "plastic/1");
  CHECK(runs[0]["state"] == "done");
  CHECK(runs[0]["generations"] == 5);
  CHECK(runs[0]["seed"].is_string());  // 64 bits, which JSON's numbers lack
  CHECK(runs[0]["best"]["seasons"].size() == 2);
  CHECK(runs[0]["best"]["rules"][0]["held"].size() == 2);
  CHECK(runs[2]["state"] == "unfinished");
  CHECK(runs[11]["state"] == "missing");
  CHECK(runs[11]["experiment"] == "tilted");
  CHECK_FALSE(runs[11].contains("seed"));
}

TEST_CASE("Whatever a table is of has a name", "[report_json]") {
  const json report = JsonOf(ReportedStudy::Get().report);
  std::set<json> measures;
  std::set<json> experiments;
  for (const json& one : report["measures"]) measures.insert(one["id"]);
  for (const json& one : report["experiments"]) experiments.insert(one["name"]);
  const std::set<json> seasons(report["seasons"].begin(),
                               report["seasons"].end());
  for (const char* table : {"curves", "finals", "tests"})
    for (const json& one : report[table]) {
      CHECK(measures.contains(one["measure"]));
      CHECK(seasons.contains(one["season"]));
    }
  for (const char* table : {"curves", "finals", "diversity", "plasticity",
                            "servo_errors", "regulation", "runs", "constants"})
    for (const json& one : report[table])
      CHECK(experiments.contains(one["experiment"]));
  for (const json& one : report["tests"]) {
    CHECK(experiments.contains(one["first"]));
    CHECK(experiments.contains(one["second"]));
  }
}

TEST_CASE("Curves and boxes are of means and of the best robots",
          "[report_json]") {
  const json report = JsonOf(ReportedStudy::Get().report);
  for (const char* table : {"curves", "finals"}) {
    std::map<std::string, int> counts;
    for (const json& one : report[table]) ++counts[one["of"]];
    CHECK(counts["mean"] > 20);
    CHECK(counts["best"] == counts["mean"]);
  }
}

TEST_CASE("The JSON says in what experiments differ", "[report_json]") {
  const json report = JsonOf(ReportedStudy::Get().report);
  std::map<std::string, json> by_key;
  for (const json& one : report["differences"])
    by_key[one["key"].get<std::string>()] = one;
  CHECK(by_key["encoding"]["paper"] == "plasticoding");
  CHECK(by_key["encoding"]["between"] == true);
  CHECK(by_key["encoding"]["values"]["baseline"] == "baseline");
  CHECK(by_key["population"]["paper"] == "100");
  CHECK(by_key["population"]["between"] == false);
  CHECK(
      by_key["scenario.seasons.slope.terrain"]["values"]["plastic"].is_null());
}

TEST_CASE("Counts by symbol and by clause are of the same rules",
          "[report_json]") {
  const json regulation = JsonOf(ReportedStudy::Get().report)["regulation"][0];
  for (const char* kind : {"symbols", "clauses"}) {
    int total = 0;
    for (const json& item : regulation[kind]) {
      int held = 0;
      for (const json& one : item["held"]) held += one["rules"].get<int>();
      CHECK(held == item["rules"]);
      total += held;
    }
    // 8 survivors in each of 3 runs, with two rules a symbol.
    CHECK(total == 3 * 8 * 10);
  }
}

TEST_CASE("Numbers have six digits, and none is null", "[report_json]") {
  StudyReport report;
  report.measures = *ChooseMeasures("speed");
  report.seasons = {"flat"};
  report.generation = 1;
  ReportExperiment one;
  one.name = "</script><b>\xff";  // no UTF-8
  one.runs = {0};
  one.seasons = {0};
  one.experiment.scenario.seasons.resize(1);
  report.experiments = {one};
  ReportRun run;
  run.reading.state = RunState::kUnfinished;
  run.reading.population.seasons = {"flat"};
  run.reading.population.generations = 2;
  run.reading.population.series = {{{NAN, 1.23456789}, {}, {}}};
  report.runs = {run};
  const json printed = JsonOf(report);
  CHECK(printed["curves"][0]["median"][0].is_null());
  CHECK(printed["curves"][0]["median"][1] == 1.23457);
  CHECK(printed["experiments"][0]["name"] == "</script><b>\xef\xbf\xbd");
}

}  // namespace plsc
