#include "runtime/cli/running/relive.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "runtime/evolve/worker_request.h"
#include "runtime/scenario/scenario_physics.h"
#include "runtime/workers/worker_count.h"

namespace plsc::cli {

Relive::Relive(const Experiment& experiment, std::optional<int> jobs)
    : planner_(experiment.scenario),
      pool_({WorkerCount(jobs.value_or(0)), HangSeconds(experiment)},
            WorkOf(planner_)),
      evaluator_(planner_, pool_, {}) {}

std::vector<EvaluatedLife> Relive::Live(std::vector<Individual> robots) {
  for (Individual& robot : robots) robot.evaluation = {};
  std::vector<EvaluatedLife> lives(robots.size());
  const auto keep = [&](std::vector<EvaluatedRobot> lived) -> MaybeFailure {
    for (EvaluatedRobot& one : lived) lives[one.robot] = std::move(one.life);
    return std::nullopt;
  };
  if (!Live(robots, keep, [] { return false; })) lives.clear();
  return lives;
}

bool Relive::Live(const std::vector<Individual>& robots,
                  const OnLives& on_lives,
                  const std::function<bool()>& should_stop) {
  constexpr int kPatience = 100;  // ms
  evaluator_.Begin(robots);
  bool is_stopped = false;
  while (!evaluator_.failure() && (is_stopped ? pool_.outstanding() > 0
                                              : evaluator_.outstanding() > 0)) {
    std::vector<EvaluatedRobot> lived = evaluator_.Wait(kPatience);
    if (!lived.empty() && !failure_) failure_ = on_lives(std::move(lived));
    if (is_stopped || (!failure_ && !should_stop())) continue;
    is_stopped = true;
    evaluator_.Cancel();
  }
  return !is_stopped && !failure();
}

Expected<Survivors, Failure> SurvivorsOf(RunStore& store, std::size_t most) {
  const Expected<RunStatus, Failure> status = store.Status();
  if (!status) return status.error();
  if (status->generations == 0)
    return Failure("no generation is completed yet, so nobody survived");
  Survivors survivors{status->generations - 1, {}};
  const Expected<GenerationRecord, Failure> record =
      store.Generation(survivors.generation);
  if (!record) return record.error();
  std::map<int, int> counts;  // by id
  for (std::size_t i = 0; i < record->pool.size(); ++i)
    counts[record->pool[i]] = record->counts[i];
  survivors.ids = record->survivors;
  std::sort(survivors.ids.begin(), survivors.ids.end(), [&](int a, int b) {
    return std::pair(-counts[a], a) < std::pair(-counts[b], b);
  });
  survivors.ids.resize(std::min(most, survivors.ids.size()));
  return survivors;
}

Expected<EngineCheck, Failure> CheckByEngine(RunStore& store,
                                             const std::vector<int>& ids,
                                             EngineKind engine,
                                             std::optional<int> jobs) {
  Experiment experiment = store.experiment();
  if (const auto problem = SetEngine(experiment.scenario, engine))
    return Failure(fmt::format("'{}' cannot be lived by the engine {}: {}",
                               store.path(), NameIn(kEngineNames, engine),
                               problem->message));
  std::vector<Individual> robots;
  for (const int id : ids) {
    Expected<Individual, Failure> one = store.FindFirstLife(id);
    if (!one) return one.error();
    if (one->evaluation.seasons.empty())
      return Failure(fmt::format("{} is not evaluated yet", id));
    robots.push_back(std::move(*one));
  }
  Relive relive(experiment, jobs);
  std::vector<EvaluatedLife> lives = relive.Live(robots);
  if (lives.empty() && relive.failure()) return *relive.failure();
  std::vector<LivedTwice> twice;
  for (std::size_t i = 0; i < robots.size(); ++i)
    twice.push_back({robots[i].id, std::move(robots[i].evaluation),
                     std::move(lives[i].evaluation)});
  return EngineCheck{engine, -1, static_cast<int>(twice.size()),
                     CheckSeasons(store.experiment().scenario, twice)};
}

}  // namespace plsc::cli
