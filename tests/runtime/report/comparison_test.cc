#include "runtime/report/comparison.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "tests/runtime/report/reported_study.h"

namespace plsc {
namespace {

using test::ReportedStudy;

/// Runs that need no store: what was read of them is written here.
struct Made {
  StudyReport report;

  Made() {
    report.measures = *ChooseMeasures("size");
    report.seasons = {"flat"};
    report.generation = 1;
    for (const char* name : {"a", "b"}) {
      ReportExperiment one;
      one.name = name;
      one.seasons = {0};
      report.experiments.push_back(one);
    }
  }
  void Add(std::size_t experiment, std::vector<double> means) {
    ReportRun run;
    run.reading.population.seasons = {"flat"};
    run.reading.population.generations = static_cast<int>(means.size());
    std::vector<double> best;
    for (const double mean : means) best.push_back(mean + 0.5);
    run.reading.population.series = {{std::move(means), {}, std::move(best)}};
    report.experiments[experiment].runs.push_back(report.runs.size());
    report.runs.push_back(std::move(run));
  }
};

}  // namespace

TEST_CASE("Curves are quartiles of the runs that got there", "[comparison]") {
  Made made;
  made.Add(0, {1, 10});
  made.Add(0, {2, 20});
  made.Add(0, {4});
  made.Add(0, {NAN, NAN});
  made.Add(1, {});
  const std::vector<Curve> curves = CurvesOf(made.report);
  REQUIRE(curves.size() == 1);  // b has nothing to show
  CHECK(curves[0].experiment == 0);
  CHECK(curves[0].counts == std::vector<int>{3, 2});
  CHECK(curves[0].quartiles[0].median == 2);
  CHECK(curves[0].quartiles[0].high == 3);
  CHECK(curves[0].quartiles[1].median == 15);
}

TEST_CASE("The best robots have curves and boxes of their own",
          "[comparison]") {
  Made made;
  made.Add(0, {1, 10});
  made.Add(0, {2, 20});
  made.Add(0, {NAN, NAN});
  const std::vector<Curve> curves = CurvesOf(made.report, Counted::kBest);
  REQUIRE(curves.size() == 1);
  CHECK(curves[0].of == Counted::kBest);
  CHECK(curves[0].counts == std::vector<int>{2, 2});
  CHECK(curves[0].quartiles[1].median == 15.5);
  const std::vector<Finals> finals = FinalsOf(made.report, Counted::kBest);
  REQUIRE(finals.size() == 1);
  CHECK(finals[0].values[0].value == 10.5);
  CHECK(finals[0].box.mean == 15.5);
  // Of one run alone it is that robot.
  made.report.experiments[0].runs = {1};
  made.report.is_single = true;
  CHECK(CurvesOf(made.report, Counted::kBest)[0].quartiles[0].high == 2.5);
}

TEST_CASE("Finals are of the runs that completed the generation",
          "[comparison]") {
  Made made;
  made.Add(0, {1, 10});
  made.Add(0, {2});
  made.Add(0, {4, 30});
  made.Add(1, {5, 20});
  made.Add(1, {5, 5});
  made.Add(1, {5, NAN});
  const std::vector<Finals> finals = FinalsOf(made.report);
  REQUIRE(finals.size() == 2);
  REQUIRE(finals[0].values.size() == 2);
  CHECK(finals[0].values[1].run == 2);
  CHECK(finals[0].values[1].value == 30);
  CHECK(finals[0].box.mean == 20);
  CHECK(finals[1].values.size() == 2);

  const std::vector<Test> tests = TestsOf(made.report, finals);
  REQUIRE(tests.size() == 1);
  CHECK(tests[0].first_runs == 2);
  REQUIRE(tests[0].result);
  CHECK(tests[0].result->w == 3);
  CHECK(tests[0].result->p == Approx(2.0 / 3));
}

TEST_CASE("Neither static experiments nor single runs are tested",
          "[comparison]") {
  for (const bool is_static : {true, false}) {
    Made made;
    made.report.experiments[1].is_static = is_static;
    made.Add(0, {1, 10});
    made.Add(0, {2, 11});
    made.Add(1, {5, 20});
    if (is_static) made.Add(1, {5, 21});
    CHECK(TestsOf(made.report, FinalsOf(made.report)).empty());
  }
}

TEST_CASE("Of a report without a generation there is nothing to compare",
          "[comparison]") {
  Made made;
  made.report.generation = -1;
  made.Add(0, {});
  CHECK(CurvesOf(made.report).empty());
  CHECK(FinalsOf(made.report).empty());
  CHECK(DiversityOf(made.report).empty());
  CHECK(PlasticityOf(made.report).empty());
}

TEST_CASE("A study's every measure is compared in every season",
          "[comparison]") {
  const StudyReport& report = ReportedStudy::Get().report;
  const std::vector<Finals> finals = FinalsOf(report);
  // Two seasons, in each plastic, baseline and a static one; Balance and
  // others are numbers, too.
  CHECK(CurvesOf(report).size() == report.measures.size() * 2 * 3);
  CHECK(finals.size() == report.measures.size() * 2 * 3);
  const std::vector<Test> tests = TestsOf(report, finals);
  CHECK(tests.size() == report.measures.size() * 2);
  for (const Test& test : tests) {
    CHECK(test.first == 0);
    CHECK(test.second == 1);
    CHECK(test.first_runs == 2);  // plastic/3 was stopped
    CHECK(test.second_runs == 3);
  }
}

TEST_CASE("Plasticity is zero for the baseline, and not for the other",
          "[comparison]") {
  const StudyReport& report = ReportedStudy::Get().report;
  const std::vector<CensusCurves> curves = PlasticityOf(report);
  REQUIRE(curves.size() == 2);  // one season shows nothing
  CHECK(curves[0].counts.front() == 3);
  CHECK(curves[0].counts.back() == 2);
  REQUIRE(curves[0].parts.size() == PlasticityParts().size());
  for (std::size_t i = 0; i < curves[0].parts.size(); ++i) {
    INFO(PlasticityParts()[i].id);
    const auto& plastic = curves[0].parts[i];
    CHECK(plastic.size() == 5);
    if (i != 1) CHECK(plastic.back().high > 0);
    CHECK(plastic.back().high <= 1);
    CHECK(curves[1].parts[i].back().high == 0);
  }
  CHECK_FALSE(RulesOf(report, 0).empty());
  CHECK(RulesOf(report, 1).empty());
}

TEST_CASE("Diversity is counted of every experiment", "[comparison]") {
  const StudyReport& report = ReportedStudy::Get().report;
  const std::vector<CensusCurves> curves = DiversityOf(report);
  REQUIRE(curves.size() == 4);
  for (const CensusCurves& one : curves) {
    const double population =
        report.experiments[one.experiment].experiment.population;
    REQUIRE(one.parts.size() == DiversityParts().size());
    for (const auto& part : one.parts) {
      CHECK(part.size() == 5);
      CHECK(part.back().low >= 1);
      CHECK(part.front().high <= population);
    }
    // All founders, and then fewer.
    CHECK(one.parts[2].front().low == population);
    CHECK(one.parts[2].back().low < population);
  }
}

TEST_CASE("What servos did is told of runs that measured it", "[comparison]") {
  Made made;
  made.Add(0, {1});
  made.Add(0, {1});
  made.Add(0, {1});
  made.Add(1, {1});
  const auto set = [&](std::size_t run, double median, double worst) {
    made.report.runs[run].reading.population.errors = {{median, worst}};
  };
  set(0, 0.1, 2);
  set(1, NAN, NAN);
  set(2, 0.3, 1);
  const std::vector<ServoObedience> all = ObedienceOf(made.report);
  REQUIRE(all.size() == 2);
  CHECK(all[0].runs == 2);
  CHECK(all[0].errors.median == Approx(0.2));
  CHECK(all[0].errors.worst == 2);
  CHECK(all[1].experiment == 1);
  CHECK(all[1].runs == 0);
  CHECK(std::isnan(all[1].errors.median));
}

TEST_CASE("A single run's curves are its population's", "[comparison]") {
  const StudyReport report = BuildReport(
      *FindRuns({ReportedStudy::Get().folder + "/plastic/1.sqlite"}),
      *ChooseMeasures("size"), {});
  const std::vector<Curve> curves = CurvesOf(report);
  REQUIRE(curves.size() == 2);
  const auto& spreads = report.runs[0].reading.population.of(0, 1).spreads;
  CHECK(curves[1].counts == std::vector<int>(5, 1));
  CHECK(curves[1].quartiles[4].high == spreads[4].high);
  CHECK(curves[1].quartiles[4].low < curves[1].quartiles[4].high);
  CHECK(TestsOf(report, FinalsOf(report)).empty());
}

}  // namespace plsc
