#include "runtime/report/swaps.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

/// Runs of an experiment in "flat" and "hill" whose plastic robots lose this
/// much in flat, m/s; nothing: no robot is plastic.
StudyReport ReportOf(const std::vector<std::optional<double>>& losses) {
  StudyReport report;
  report.seasons = {"flat", "hill"};
  report.generation = 3;
  ReportExperiment plastic;
  plastic.name = "plastic";
  plastic.seasons = {0, 1};
  for (const std::optional<double>& loss : losses) {
    plastic.runs.push_back(report.runs.size());
    ReportRun run;
    run.relived.state = RelivedState::kHere;
    RelivedGeneration& generation = run.relived.generation;
    generation.seasons = 2;
    generation.measures.resize(RelivedMeasures().size() * 2);
    if (loss)
      for (std::size_t i = 0; i < generation.measures.size(); i += 2) {
        generation.measures[i].swapped = 4;
        generation.measures[i].own = 0.02;
        generation.measures[i].other = 0.02 - *loss;
      }
    report.runs.push_back(std::move(run));
  }
  report.experiments.push_back(std::move(plastic));
  return report;
}

TEST_CASE("losses are of runs, in cm/s, and tested against none", "[swaps]") {
  const std::vector<SwapLosses> all =
      SwapLossesOf(ReportOf({0.01, 0.02, std::nullopt, 0.04}));
  REQUIRE(all.size() == 2);  // Speed and fitness, of flat alone
  CHECK(all[0].measure == "displacement_velocity_hill");
  CHECK(all[1].measure == "fitness");
  CHECK(all[0].season == 0);
  REQUIRE(all[0].runs.size() == 3);
  CHECK(all[0].runs[2].run == 3);
  CHECK(all[0].runs[0].robots == 4);
  CHECK(all[0].runs[0].own == Approx(2));
  CHECK(all[0].runs[0].swapped == Approx(1));
  CHECK(all[0].box.quartiles.median == Approx(2));
  REQUIRE(all[0].result);
  CHECK(all[0].result->p == Approx(0.25));
}

TEST_CASE("runs without plastic robots or relived lives have no losses",
          "[swaps]") {
  CHECK(SwapLossesOf(ReportOf({std::nullopt})).empty());
  StudyReport report = ReportOf({0.01});
  report.runs[0].relived.state = RelivedState::kOlder;
  CHECK(SwapLossesOf(report).empty());
}

}  // namespace
}  // namespace plsc
