#pragma once

// A run of evolution, from the experiment to the final population (paper,
// "Evolution"): overlapping generations, one child a pair, parents and
// survivors by tournaments on domination counts. Prints nothing, reads no
// clock and opens no file; whoever calls does, through the callbacks.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "runtime/evolve/experiment.h"
#include "runtime/evolve/individual.h"
#include "runtime/evolve/run_observer.h"

namespace plsc {

/// The best and the middle fitness of one season, m/s; nothing where that
/// robot has no fitness.
struct SeasonProgress {
  std::string season;
  std::optional<double> best;
  std::optional<double> median;  ///< the lower of two in the middle
};

struct Progress {
  int generation = 0;            ///< being evaluated
  std::int64_t evaluations = 0;  ///< done, of all generations
  std::int64_t total = 0;        ///< of the whole run
  int workers = 0;
  int busy_workers = 0;  ///< at this moment
  /// Of the population; of those evaluated so far in generation 0.
  std::vector<SeasonProgress> seasons;
};

using Evaluator = std::function<Evaluation(const Genotype&)>;

struct EvolveOptions {
  int jobs = 0;  ///< worker processes; 0: as many as there are cores
  /// Runs in the workers; empty: Evaluate with the experiment's scenario.
  Evaluator evaluate;
  /// Asked at least ten times a second; true ends the run when what the
  /// workers have begun is done.
  std::function<bool()> should_stop;
  std::function<void(const Progress&)> on_progress;
  std::vector<RunObserver*> observers;
};

enum class Ending : std::uint8_t { kFinished, kStopped, kFailed };

struct RunResult {
  Ending ending = Ending::kFinished;
  std::string failure;           ///< kFailed only
  int generations = 0;           ///< completed, the initial one included
  std::int64_t evaluations = 0;  ///< seen by the observers
  /// Of the last completed generation, and the domination counts that they
  /// survived with.
  std::vector<Individual> population;
  std::vector<int> counts;
  /// The highest count of the population, ties by lowest id; nothing if no
  /// generation was completed.
  std::optional<Individual> best;
};

/// A function of the experiment alone: neither `jobs` nor the callbacks change
/// a bit of what observers see, unless a worker dies. Forks; so call it from
/// the only thread. The scenario answers all states (CheckSenses).
RunResult Evolve(const Experiment& experiment, const EvolveOptions& options);

}  // namespace plsc
