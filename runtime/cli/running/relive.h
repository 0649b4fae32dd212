#pragma once

// Robots of a run live again, on workers, as a run lives them but that nothing
// is looked up: in the scenario of the run, or in it by another engine.

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "grammar/expected.h"
#include "grammar/failure.h"
#include "runtime/evolve/generation_evaluator.h"
#include "runtime/report/engine_check.h"
#include "runtime/store/run_store.h"
#include "runtime/workers/worker_pool.h"

namespace plsc::cli {

class Relive {
 public:
  /// `jobs` as RunRequest's.
  Relive(const Experiment& experiment, std::optional<int> jobs);

  /// In the order of `robots`, whatever their evaluations; empty if there are
  /// no workers any more, which failure() tells.
  std::vector<EvaluatedLife> Live(std::vector<Individual> robots);

  using OnLives = std::function<MaybeFailure(std::vector<EvaluatedRobot>)>;
  /// As they are lived, robots by their places; asks ten times a second whether
  /// to stop, and then lives what was begun. Whether all lived. Whose
  /// `on_lives` fails, or who stops, is done with this object.
  bool Live(const std::vector<Individual>& robots, const OnLives& on_lives,
            const std::function<bool()>& should_stop);
  /// What went wrong, if anything did.
  const MaybeFailure& failure() const {
    return failure_ ? failure_ : evaluator_.failure();
  }

 private:
  const LifePlanner planner_;
  WorkerPool pool_;
  GenerationEvaluator evaluator_;
  MaybeFailure failure_;
};

/// Of the population of the last completed generation, the best first: by their
/// counts, then by age. All of them, or `most`.
struct Survivors {
  int generation = 0;
  std::vector<int> ids;
};
Expected<Survivors, Failure> SurvivorsOf(RunStore& store, std::size_t most);

/// The robots of these ids as they are stored, and by the engine.
Expected<EngineCheck, Failure> CheckByEngine(RunStore& store,
                                             const std::vector<int>& ids,
                                             EngineKind engine,
                                             std::optional<int> jobs);

}  // namespace plsc::cli
