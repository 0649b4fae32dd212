#include "runtime/report/swaps.h"

#include <algorithm>
#include <utility>

#include "runtime/text/quantity.h"

namespace plsc {

namespace {

std::vector<RunSwap> SwapsOfRuns(const StudyReport& report,
                                 const ReportExperiment& experiment,
                                 std::size_t measure, std::size_t own_season) {
  std::vector<RunSwap> swaps;
  for (const std::size_t run : experiment.runs) {
    const RelivedReading& relived = report.runs[run].relived;
    if (relived.state != RelivedState::kHere ||
        own_season >= relived.generation.seasons)
      continue;
    const RelivedMeasure& one = relived.generation.of(measure, own_season);
    if (one.swapped > 0)
      swaps.push_back(
          {run, one.swapped, kCentimetres * one.own, kCentimetres * one.other});
  }
  return swaps;
}

bool IsFormula(const StudyReport& report) {
  return std::any_of(report.experiments.begin(), report.experiments.end(),
                     [](const ReportExperiment& one) {
                       return HasOwnFitness(one.experiment);
                     });
}

}  // namespace

std::vector<SwapLosses> SwapLossesOf(const StudyReport& report) {
  const std::vector<std::string>& known = RelivedMeasures();
  std::vector<SwapLosses> all;
  for (const char* id : {"displacement_velocity_hill", kFitnessMeasure}) {
    // What a formula comes to is no speed in cm/s.
    if (id == std::string_view(kFitnessMeasure) && IsFormula(report)) continue;
    const auto measure = static_cast<std::size_t>(
        std::find(known.begin(), known.end(), id) - known.begin());
    for (std::size_t season = 0; season < report.seasons.size(); ++season)
      for (std::size_t i = 0; i < report.experiments.size(); ++i) {
        const ReportExperiment& experiment = report.experiments[i];
        const auto own = std::find(experiment.seasons.begin(),
                                   experiment.seasons.end(), season);
        if (own == experiment.seasons.end()) continue;
        std::vector<RunSwap> runs = SwapsOfRuns(
            report, experiment, measure,
            static_cast<std::size_t>(own - experiment.seasons.begin()));
        if (runs.empty()) continue;
        std::vector<double> losses;
        losses.reserve(runs.size());
        for (const RunSwap& run : runs) losses.push_back(run.own - run.swapped);
        const auto result = SignedRankTest(losses);
        all.push_back({id, season, i, std::move(runs),
                       BoxPlotOf(std::move(losses)), result});
      }
  }
  return all;
}

}  // namespace plsc
