#include "runtime/study/run_report.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "runtime/store/lock.h"
#include "runtime/store/run_store.h"
#include "runtime/study/study_folder.h"

namespace plsc {

namespace {

RunReport Damaged(const Failure& failure) {
  RunReport report;
  report.state = RunState::kDamaged;
  report.problem = failure.text;
  return report;
}

std::vector<SeasonSpeed> SpeedsOf(const Individual& best) {
  std::vector<SeasonSpeed> speeds;
  for (const SeasonResult& season : best.evaluation.seasons) {
    const Behaviour& behaviour = season.behaviour;
    speeds.push_back({season.season,
                      behaviour.is_valid
                          ? std::optional(behaviour.displacement_velocity_hill)
                          : std::nullopt});
  }
  return speeds;
}

}  // namespace

RunReport ReportOn(const std::string& folder, const Study& study,
                   const StudyRun& run) {
  const std::string path = RunPath(folder, study, run);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return {};
  // Asked first: a run that ends meanwhile is then taken for running, not for
  // one that nobody works on.
  const std::optional<std::string> worker = WhoWorksOn(path);
  RunStore store;
  if (auto failure = store.OpenForReading(path)) return Damaged(*failure);
  if (!AreSame(store.experiment(), ExperimentOf(study, run)))
    return Damaged(fmt::format(
        "'{}' is a run of another experiment or seed than the study's", path));
  const Expected<RunStatus, Failure> status = store.Status();
  if (!status) return Damaged(status.error());
  RunReport report;
  report.state = status->is_finished ? RunState::kDone
                 : worker            ? RunState::kRunning
                                     : RunState::kUnfinished;
  report.worker = worker.value_or("");
  report.generations = status->generations;
  report.evaluations = status->evaluations;
  if (status->best == 0) return report;
  const Expected<Individual, Failure> best = store.Find(status->best);
  if (!best) return Damaged(best.error());
  report.best = SpeedsOf(*best);
  return report;
}

}  // namespace plsc
