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
  evaluator_.Begin(robots);
  while (evaluator_.outstanding() > 0 && !evaluator_.failure())
    for (EvaluatedRobot& one : evaluator_.Wait(1000))
      lives[one.robot] = std::move(one.life);
  if (evaluator_.failure()) lives.clear();
  return lives;
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
