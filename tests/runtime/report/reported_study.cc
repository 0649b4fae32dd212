#include "tests/runtime/report/reported_study.h"

#include <catch2/catch.hpp>

namespace plsc::test {

namespace {

Study FourExperiments() {
  Study study = SmallStudy();
  study.name = "reported";
  study.repetitions = 3;
  Experiment flat = study.experiments[1].experiment;
  Experiment tilted = flat;
  flat.scenario.seasons.pop_back();
  tilted.scenario.seasons.erase(tilted.scenario.seasons.begin());
  tilted.scenario.seasons[0].name = "slope";
  study.experiments.push_back({"flat", flat});
  study.experiments.push_back({"tilted", tilted});
  return study;
}

}  // namespace

ReportedStudy::ReportedStudy() {
  constexpr int kEarly = 16;  // of 32 evaluations
  const Study study = FourExperiments();
  REQUIRE_FALSE(PrepareFolder(folder, study));
  for (const StudyRun& run : RunsOf(study)) {
    const std::string name = RunName(study, run);
    if (name == "tilted/3") continue;
    const RunEnd end = Execute(
        {run, RunPath(folder, study, run), ExperimentOf(study, run), false},
        name == "plastic/3" ? kEarly : 0);
    REQUIRE(end ==
            (name == "plastic/3" ? RunEnd::kStopped : RunEnd::kFinished));
  }
  report = BuildReport(*FindRuns({folder}), AllMeasures(), {});
}

const ReportedStudy& ReportedStudy::Get() {
  static const ReportedStudy reported;
  return reported;
}

}  // namespace plsc::test
