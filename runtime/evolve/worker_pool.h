#pragma once

// Workers that are processes of this machine. Processes and not threads,
// because a robot that crashes the physics must not end the run:
// docs/decisions/0002-workers-are-processes.md. One that dies or hangs is
// replaced and its request begun again, once.

#include <sys/types.h>

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "runtime/evolve/workers.h"

namespace plsc {

struct WorkerPoolOptions {
  int workers = 1;
  /// s without an answer after which a worker is taken to hang; 0: no limit.
  double hang_seconds = 0;
};

/// Workers are forked from the thread that makes the pool, which must be the
/// only one; they die with it. Whoever made the pool also uses it.
class WorkerPool : public Workers {
 public:
  WorkerPool(const WorkerPoolOptions& options, Work work);
  /// Without a limit on hanging.
  WorkerPool(int workers, Work work)
      : WorkerPool(WorkerPoolOptions{workers, 0}, std::move(work)) {}
  ~WorkerPool() override;

  void Submit(int ticket, std::string request) override;
  void CancelWaiting() override;
  std::vector<Reply> Wait(int timeout_ms) override;

  int workers() const override { return static_cast<int>(workers_.size()); }
  int busy() const override;
  int outstanding() const override {
    return busy() + static_cast<int>(waiting_.size());
  }
  const std::optional<std::string>& failure() const override {
    return failure_;
  }

 private:
  struct Request {
    int ticket = 0;
    std::string text;
    int deaths = 0;  // of workers that had it
  };
  struct Worker {
    pid_t pid = 0;
    int socket = -1;
    std::optional<Request> request;  // what it works on
    std::string received;            // of the frame of its answer
  };

  std::optional<Worker> Start();
  [[noreturn]] void Serve(int socket, pid_t parent) const;
  void HandOut();
  std::optional<Reply> Receive(Worker& worker);
  std::optional<Reply> Bury(Worker& worker);

  Work work_;
  std::vector<Worker> workers_;
  std::deque<Request> waiting_;
  std::optional<std::string> failure_;
};

}  // namespace plsc
