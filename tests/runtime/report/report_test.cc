#include "runtime/report/report.h"

#include <catch2/catch.hpp>

#include "runtime/study/study_folder.h"
#include "tests/runtime/report/reported_study.h"

namespace plsc {

using test::ReportedStudy;

TEST_CASE("Experiments of a study are told apart, static ones as such",
          "[report]") {
  const ReportedStudy& reported = ReportedStudy::Get();
  const StudyReport& report = reported.report;
  REQUIRE(report.experiments.size() == 4);
  CHECK(report.experiments[0].name == "plastic");
  CHECK(report.experiments[0].runs == std::vector<std::size_t>{0, 1, 2});
  CHECK_FALSE(report.experiments[0].is_static);
  CHECK_FALSE(report.experiments[1].is_static);
  CHECK(report.experiments[2].is_static);
  CHECK(report.experiments[3].is_static);
  CHECK(report.seasons == std::vector<std::string>{"flat", "tilted"});
  // The static slope has a name of its own, and the ground of the other.
  CHECK(report.experiments[3].experiment.scenario.seasons[0].name == "slope");
  CHECK(report.experiments[2].seasons == std::vector<std::size_t>{0});
  CHECK(report.experiments[3].seasons == std::vector<std::size_t>{1});
  CHECK(report.generation == 4);
  CHECK_FALSE(report.is_single);
}

TEST_CASE("Progress is told run by run", "[report]") {
  const ReportedStudy& reported = ReportedStudy::Get();
  std::vector<std::size_t> told;
  BuildReport(*FindRuns({reported.folder + "/plastic"}), PaperMeasures(),
              [&](std::size_t done, std::size_t total) {
                told.push_back(done);
                CHECK(total == 3);
              });
  CHECK(told == std::vector<std::size_t>{1, 2, 3});
}

TEST_CASE("Files belong together by what they are, not by their names",
          "[report]") {
  const ReportedStudy& reported = ReportedStudy::Get();
  const test::Scratch scratch;
  const auto copy = [&](const char* from, const char* to) {
    test::WriteBytes(scratch / to,
                     test::ReadBytes(reported.folder + "/" + from));
  };
  copy("plastic/1.sqlite", "x.sqlite");
  copy("baseline/1.sqlite", "y.sqlite");
  copy("plastic/2.sqlite", "z.sqlite");
  test::WriteBytes(scratch / "w.sqlite", "no run at all");
  const StudyReport report =
      BuildReport(*FindRuns({scratch.path().string()}), PaperMeasures(), {});
  REQUIRE(report.runs.size() == 4);
  CHECK(report.runs[0].reading.state == RunState::kDamaged);
  REQUIRE(report.experiments.size() == 2);
  CHECK(report.experiments[0].name == "reported plastic");
  CHECK(report.experiments[0].runs == std::vector<std::size_t>{1, 3});
  CHECK(report.experiments[1].runs == std::vector<std::size_t>{2});
}

TEST_CASE("One run alone is shown by its population", "[report]") {
  const ReportedStudy& reported = ReportedStudy::Get();
  const StudyReport report = BuildReport(
      *FindRuns({reported.folder + "/flat/1.sqlite"}), PaperMeasures(), {});
  CHECK(report.is_single);
  REQUIRE(report.experiments.size() == 1);
  CHECK_FALSE(report.experiments[0].is_static);  // there is nothing else
  CHECK(report.runs[0].reading.population.of(0, 0).spreads.size() == 5);
}

TEST_CASE("Experiments are compared where each has a run", "[report]") {
  const ReportedStudy& reported = ReportedStudy::Get();
  // plastic/3 was stopped early, which plastic/1 makes up for; alone with the
  // baseline it is the one that counts.
  const StudyReport early =
      BuildReport(*FindRuns({reported.folder + "/plastic/3.sqlite",
                             reported.folder + "/baseline"}),
                  PaperMeasures(), {});
  CHECK(early.generation == early.runs[0].reading.population.generations - 1);
  CHECK(early.generation < 4);
}

}  // namespace plsc
