#pragma once

// A run on the ranks of an MPI job (`mpirun -n N plsc evolve ...`): every rank
// starts the same program, rank 0 is the run, and the others only lend it
// their workers. docs/decisions/0011-ranks-lend-their-workers.md. How a command
// uses it, before it opens a file and before anything makes a thread:
//
//   if (const auto obstacle = MpiSession::Obstacle()) return Fail(*obstacle);
//   std::unique_ptr<MpiSession> session;  // outlives the workers made by it
//   if (MpiSession::IsUnderMpi()) {
//     session = MpiSession::Join({jobs.value_or(1), hang_seconds},
//         [](const std::string& setup) { return JudgeFor(setup); });
//     if (session->rank() != 0) return session->Serve(), Exit::kFine;
//   }
//   ... only rank 0: read files, open the store, and then
//   auto workers = session ? session->MakeWorkers(experiment_text)
//                          : std::make_unique<WorkerPool>(...);

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "runtime/evolve/worker_pool.h"
#include "runtime/evolve/workers.h"

namespace plsc {

/// What workers do, from a text that tells all of a run that they need (the
/// experiment with its scenario): they read no file, so only rank 0 needs to
/// see any. Called in the workers, when the first request comes.
using MakeWork = std::function<Work(const std::string& setup)>;

class MpiSession {
 public:
  /// Whether mpirun, or another launcher that MPI knows, has started us beside
  /// others. From the environment alone; costs nothing.
  static bool IsUnderMpi();
  /// Why we cannot take part though IsUnderMpi: built without MPI. Then all
  /// ranks would do the same run, and fight for one store.
  static std::optional<std::string> Obstacle();
  /// Forks this rank's workers (so call it from the only thread), and then
  /// meets the other ranks. Once in a process.
  static std::unique_ptr<MpiSession> Join(const WorkerPoolOptions& options,
                                          MakeWork make_work);
  /// On rank 0 also the end of Serve on all others.
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;

  int rank() const;
  int size() const;
  /// Rank 0, once: the workers of all ranks.
  std::unique_ptr<Workers> MakeWorkers(std::string setup);
  /// The others: lends the workers until rank 0 is at its end. Ignores SIGINT
  /// and SIGTERM, which are rank 0's to act on.
  void Serve();

 private:
  struct State;
  explicit MpiSession(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace plsc
