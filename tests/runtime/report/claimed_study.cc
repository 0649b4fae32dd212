#include "tests/runtime/report/claimed_study.h"

#include "runtime/text/key.h"

namespace plsc::test {

namespace {

Series SeriesOfSize(double size) {
  return {{size + 1, size}, {}, {2 * size + 1, 2 * size}};
}

}  // namespace

Claim SizeClaim(ClaimKind kind, const std::string& name) {
  Claim claim;
  claim.name = name;
  claim.measure = "size";
  claim.kind = kind;
  claim.experiments = {"a"};
  if (IsOfTwo(kind)) claim.experiments.push_back("b");
  claim.seasons = {"flat"};
  return claim;
}

StudyReport ClaimedStudy(const std::vector<Claim>& claims) {
  StudyReport report;
  report.measures = *ChooseMeasures("size");
  report.seasons = {"flat", "tilted"};
  report.generation = 1;
  ClaimsVersion version;
  version.stated = "2026-11-30T12:00:00Z";
  version.runs = 10;
  version.hash = Hex(KeyOf("claims"));
  version.claims = claims;
  report.claims = {{"claimed", {version}, ""}};
  for (const char* name : {"a", "b"}) {
    ReportExperiment one;
    one.name = name;
    one.seasons = {0, 1};
    one.experiment.scenario.seasons.resize(2);
    one.experiment.scenario.seasons[0].name = "flat";
    one.experiment.scenario.seasons[1].name = "tilted";
    for (int i = 0; i < 5; ++i) {
      ReportRun run;
      run.input.experiment = name;
      run.input.study = 0;
      run.reading.state = RunState::kDone;
      run.reading.population.seasons = {"flat", "tilted"};
      run.reading.population.generations = 2;
      const double size = i + (report.experiments.empty() ? 10 : 0);
      run.reading.population.series = {SeriesOfSize(size),
                                       SeriesOfSize(size + 1)};
      one.runs.push_back(report.runs.size());
      report.runs.push_back(std::move(run));
    }
    report.experiments.push_back(std::move(one));
  }
  return report;
}

StudyReport RelivedClaims() {
  StudyReport report = ClaimedStudy({SizeClaim(ClaimKind::kGreater, "bigger"),
                                     SizeClaim(ClaimKind::kLess, "slower")});
  report.measures = *ChooseMeasures("size,speed");
  report.claims[0].record[0].claims[1].measure = "speed";
  for (ReportRun& run : report.runs) {
    auto& series = run.reading.population.series;
    series.push_back(series[0]);
    series.push_back(series[1]);
    run.relived.state = RelivedState::kHere;
    run.relived.generation.seasons = 2;
    RelivedMeasure relived;
    relived.mean = 1 - series[0].means[1] / 100;  // m/s
    run.relived.generation.measures.assign(2 * RelivedMeasures().size(),
                                           relived);
  }
  return report;
}

}  // namespace plsc::test
