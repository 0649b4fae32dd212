#pragma once

// One run of evolution into its store, from the beginning or from where it was
// left: what `plsc evolve` does once and `plsc study run` many times.

#include <optional>
#include <string>

#include "runtime/cli/files/io.h"
#include "runtime/evolve/evolve.h"
#include "runtime/workers/mpi_session.h"

namespace plsc::cli {

struct RunRequest {
  std::string path;  ///< of the store
  /// What a new run is of. Nothing: the store's own; then it must exist.
  std::optional<Experiment> experiment;
  /// Goes on with a store that exists, if it is of the same experiment.
  bool may_resume = false;
  /// A damaged run whose whole simulations are looked up. If `experiment` is
  /// nothing it is this one's, and `path` is made.
  std::string salvage;
  /// Goes on although another version of the program made the first results.
  bool allow_other_version = false;
  std::optional<int> jobs;  ///< workers; of each rank under MPI
  /// s that a worker may take for an answer, 0 for ever; nothing: HangSeconds.
  std::optional<double> hang_seconds;
  std::string cache;     ///< a shared cache's file; empty: none
  std::string json_log;  ///< a file or "-"; empty: none
  bool quiet = false;    ///< no progress line
  MpiSession* mpi = nullptr;
};

/// What the run took, by this process and its workers.
struct Effort {
  double seconds = 0;
  double cpu_seconds = 0;
  /// Of the workers' time; nothing under MPI, where others know it.
  std::optional<double> busy_share;
  int workers = 0;
  std::int64_t evaluations = 0;
  EvaluationCounts counts;
};

struct RunOutcome {
  /// kInterrupted: stopped by a signal, to be gone on with. kBadInput: what
  /// went wrong was printed.
  Exit exit = Exit::kFine;
  /// Another process works on it; nothing was done (exit is kBadInput).
  bool is_locked = false;
  Experiment experiment;
  RunResult result;
  Effort effort;
};

/// Prints progress and what went wrong to io.err.
RunOutcome ExecuteRun(const RunRequest& request, Io& io);

}  // namespace plsc::cli
