#pragma once

// A run on the ranks of an MPI job (`mpirun -n N plsc evolve ...`): every rank
// starts the same program, rank 0 is the run, and the others only lend it
// their workers. docs/decisions/0011-ranks-lend-their-workers.md. How a command
// uses it, before it opens a file and before anything makes a thread:
//
//   MpiSession session;
//   if (MpiSession::IsUnderMpi()) {
//     if (const auto failure = session.Join(jobs.value_or(1), WorkFor))
//       return Fail(*failure);
//     if (session.rank() != 0) return session.Serve(), Exit::kFine;
//     options.make_workers = [&](const Work&) {
//       return session.MakeWorkers(PrintExperiment(experiment),
//                                  HangSeconds(experiment));
//     };
//   }

#include <memory>
#include <optional>
#include <string>

#include "runtime/workers/worker_setup.h"
#include "runtime/workers/workers.h"

namespace plsc {

class MpiSession {
 public:
  /// Whether mpirun, or another launcher that MPI knows, has started us beside
  /// others. From the environment alone; costs nothing. MPI itself takes all
  /// it knows from there, so this is the one place outside runtime/cli.
  static bool IsUnderMpi();

  MpiSession();
  /// On rank 0 also the end of Serve on all others. Workers made by
  /// MakeWorkers must be gone.
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;

  /// Forks this rank's `workers` (0: RankWorkerCount; so call it from the only
  /// thread), and then meets the other ranks; once in a
  /// process. Workers are told what to do by MakeWorkers, so they read no file,
  /// and only rank 0 needs to see any. What went wrong: ranks that cannot meet
  /// must not go on, as each of them would do the same run.
  std::optional<std::string> Join(int workers, MakeWork make_work);

  /// 0 and 1 before Join.
  int rank() const;
  int size() const;

  /// Rank 0: the workers of all ranks, for the run that `setup` tells of. The
  /// limit as in WorkerPoolOptions.
  std::unique_ptr<Workers> MakeWorkers(std::string setup, double hang_seconds);
  /// The others: lends the workers until rank 0 is at its end. They ignore
  /// SIGINT and SIGTERM, which are rank 0's to act on; SIGUSR1 is one more
  /// SIGTERM to it, as mpirun gives a job no time after the others.
  void Serve();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace plsc
