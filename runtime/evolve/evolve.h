#pragma once

// A run of evolution, from the experiment to the final population (paper,
// "Evolution"): overlapping generations, one child a pair, parents and
// survivors by tournaments on domination counts. Prints nothing, reads no
// clock and opens no file; whoever calls does, through the callbacks.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grammar/enum_names.h"
#include "runtime/evolve/experiment.h"
#include "runtime/evolve/generation_evaluator.h"
#include "runtime/evolve/individual.h"
#include "runtime/evolve/run_observer.h"
#include "runtime/evolve/saved_run.h"
#include "runtime/evolve/season_progress.h"
#include "runtime/evolve/simulation_cache.h"
#include "runtime/workers/workers.h"

namespace plsc {

struct Progress {
  int generation = 0;            ///< being evaluated
  std::int64_t evaluations = 0;  ///< robots evaluated, of the whole run
  std::int64_t total = 0;        ///< of the whole run
  int workers = 0;
  int busy_workers = 0;  ///< at this moment
  /// Since this process works on the run, in seasons of robots: simulated, and
  /// looked up because the same was simulated before.
  std::int64_t simulations = 0;
  std::int64_t looked_up = 0;
  double simulated_seconds = 0;  ///< of the simulations
  /// Of the population; of those evaluated so far in generation 0.
  std::vector<SeasonProgress> seasons;
  bool has_own_fitness = false;  ///< what seasons are worth is no speed
};

struct EvolveOptions {
  int jobs = 0;  ///< worker processes; 0: as many as there are cores
  /// Other workers than that many forked ones.
  std::function<std::unique_ptr<Workers>(const Work& work)> make_workers;
  /// Runs in the workers instead of the physics.
  SeasonSimulator simulate;
  /// Asked in this order before anything is simulated; told what was.
  std::vector<SimulationCache*> caches;
  /// Where the run stood when it was left; nothing: at the beginning.
  std::optional<SavedRun> saved;
  /// Asked at least ten times a second, whatever the run is at; true ends the
  /// run when what the workers have begun is done.
  std::function<bool()> should_stop;
  std::function<void(const Progress&)> on_progress;
  std::vector<RunObserver*> observers;
};

enum class Ending : std::uint8_t { kFinished, kStopped, kFailed };
inline constexpr EnumNames<Ending, 3> kEndingNames{
    {{Ending::kFinished, "finished"},
     {Ending::kStopped, "stopped"},
     {Ending::kFailed, "failed"}}};

struct RunResult {
  Ending ending = Ending::kFinished;
  std::string failure;              ///< kFailed only
  int generations = 0;              ///< completed, the initial one included
  std::int64_t evaluations = 0;     ///< robots evaluated, of the whole run
  EvaluationCounts counts_of_work;  ///< of this process
  /// Of the last completed generation, and the domination counts that they
  /// survived with.
  std::vector<Individual> population;
  std::vector<int> counts;
  /// The highest count of the population, ties by lowest id; nothing if no
  /// generation was completed.
  std::optional<Individual> best;
};

/// A function of the experiment alone: neither `jobs`, caches, stops nor the
/// callbacks change a bit of what observers see, unless a worker dies; only
/// the order in which evaluations are seen. Forks; so call it from the only
/// thread. The scenario answers all states (CheckSenses).
RunResult Evolve(const Experiment& experiment, const EvolveOptions& options);

}  // namespace plsc
