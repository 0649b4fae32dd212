#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <span>
#include <utility>

#include "grammar/shown_line.h"
#include "runtime/cli/arguments/runs.h"
#include "runtime/cli/commands/replay_compare.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/evolve/generation_evaluator.h"
#include "runtime/evolve/worker_request.h"
#include "runtime/life/evaluation.h"
#include "runtime/store/verify.h"
#include "runtime/text/json_dump.h"
#include "runtime/workers/worker_count.h"
#include "runtime/workers/worker_pool.h"

namespace plsc::cli {

namespace {

using Json = nlohmann::ordered_json;

void PrintText(const Replayed& replayed, std::ostream& out) {
  if (replayed.differences.empty()) {
    out << fmt::format("{}: {} values in {} seasons equal\n", replayed.id,
                       replayed.values, replayed.seasons);
    return;
  }
  out << fmt::format("{}: {} of {} values differ\n", replayed.id,
                     replayed.differences.size(), replayed.values);
  for (const Difference& one : replayed.differences)
    out << fmt::format("  season {}, {}: stored {}, now {}\n",
                       Escaped(one.season), one.name, Escaped(one.stored),
                       Escaped(one.now));
}

void PrintJson(const Replayed& replayed, std::ostream& out) {
  Json json;
  json["id"] = replayed.id;
  json["seasons"] = replayed.seasons;
  json["values"] = replayed.values;
  json["differences"] = Json::array();
  for (const Difference& one : replayed.differences)
    json["differences"].push_back({{"season", one.season},
                                   {"name", one.name},
                                   {"stored", one.stored},
                                   {"now", one.now}});
  out << DumpJson(json) << '\n';
}

struct Stored {
  Individual individual;
  std::vector<SeasonEvidence> evidence;
};

Expected<std::vector<Stored>, Failure> Load(RunStore& store,
                                            std::span<const int> ids) {
  std::vector<Stored> batch;
  for (const int id : ids) {
    Expected<Individual, Failure> one = store.Find(id);
    if (!one) return one.error();
    if (one->evaluation.seasons.empty())
      return Failure(fmt::format("{} is not evaluated yet", id));
    Expected<std::vector<SeasonEvidence>, Failure> evidence =
        store.EvidenceOf(id);
    if (!evidence) return evidence.error();
    batch.push_back({std::move(*one), std::move(*evidence)});
  }
  return batch;
}

/// Evaluates all anew, as a run does but that nothing is known.
class Replays {
 public:
  Replays(const Experiment& experiment, int jobs)
      : planner_(experiment.scenario),
        pool_({jobs, HangSeconds(experiment)}, WorkOf(planner_)),
        evaluator_(planner_, pool_, {}) {}

  /// In the order of `batch`; fewer if there are no workers any more.
  std::vector<Replayed> Evaluate(const std::vector<Stored>& batch) {
    std::vector<Individual> robots;
    for (const Stored& stored : batch) {
      robots.push_back(stored.individual);
      robots.back().evaluation = {};
    }
    std::vector<Replayed> replayed(batch.size());
    evaluator_.Begin(robots);
    while (evaluator_.outstanding() > 0 && !evaluator_.failure())
      for (const EvaluatedRobot& one : evaluator_.Wait(1000)) {
        const Stored& stored = batch[one.robot];
        replayed[one.robot] =
            Compare(stored.individual, stored.evidence, one.life);
      }
    if (evaluator_.failure()) replayed.clear();
    return replayed;
  }
  const MaybeFailure& failure() const { return evaluator_.failure(); }

 private:
  const LifePlanner planner_;
  WorkerPool pool_;
  GenerationEvaluator evaluator_;
};

}  // namespace

Exit Run(const ReplayCommand& command, Io& io) {
  RunStore store;
  if (const auto failure = store.OpenForReading(command.run))
    return Complain(*failure, io);
  // Whoever is lost with a page would not be missed otherwise.
  if (command.all)
    if (const auto problem = Examine(command.run).problem)
      return Complain(*problem, io);
  const Expected<std::vector<int>, Failure> ids =
      command.all ? EvaluatedIds(store) : IdsOf(store, command.individuals);
  if (!ids) return Complain(ids.error(), io);
  Replays replays(store.experiment(), WorkerCount(command.jobs.value_or(0)));
  // Enough for all workers, few enough to be seen going on.
  constexpr std::size_t kBatch = 50;
  std::size_t different = 0;
  std::span<const int> rest(*ids);
  while (!rest.empty()) {
    const auto now = rest.first(std::min(rest.size(), kBatch));
    rest = rest.subspan(now.size());
    const Expected<std::vector<Stored>, Failure> batch = Load(store, now);
    if (!batch) return Complain(batch.error(), io);
    const std::vector<Replayed> replayed = replays.Evaluate(*batch);
    if (replayed.empty()) return Complain(*replays.failure(), io);
    for (const Replayed& one : replayed) {
      different += one.differences.empty() ? 0 : 1;
      command.format == OutputFormat::kJson ? PrintJson(one, io.out)
                                            : PrintText(one, io.out);
    }
    io.out.flush();
  }
  if (different == 0) return Exit::kFine;
  io.err << fmt::format(
      "error: {} of {} robots came out otherwise\n"
      "= help: another version of plsc or of ODE ({} began this run), or "
      "another kind of processor, may be why\n",
      different, ids->size(), VersionsText(store.versions()));
  return Exit::kBadInput;
}

}  // namespace plsc::cli
