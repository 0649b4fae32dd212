#pragma once

// Workers that are processes of this machine. Processes and not threads,
// because a robot that crashes the physics must not end the run:
// docs/decisions/0002-workers-are-processes.md. One that dies, hangs or answers
// what is no frame is replaced and its request begun again, once.

#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/workers/worker_frame.h"
#include "runtime/workers/worker_process.h"
#include "runtime/workers/worker_watch.h"
#include "runtime/workers/workers.h"

namespace plsc {

struct WorkerPoolOptions {
  int workers = 1;
  /// s that a worker may have for one request before it is taken to hang; 0: no
  /// limit. Its own time, not the clock's: see worker_watch.h.
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

  /// As WorkerPoolOptions::hang_seconds, for requests given out from now on.
  void SetHangSeconds(double seconds) { options_.hang_seconds = seconds; }

  /// Wait also comes back when this file descriptor can be read; -1: none.
  void WakeOn(int descriptor) { wake_ = descriptor; }

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
    WorkerProcess process;
    std::optional<Request> request;  // what it works on
    std::string unsent;              // the frame of the request
    std::size_t sent = 0;            // bytes of it
    FrameReader reader;              // of the answer
    WorkerWatch watch;
    double unwatched = 0;  // s waited since the last look at it
  };

  std::optional<Worker> Start();
  void HandOut();
  bool Poll(int timeout_ms, std::vector<short>& events);
  std::optional<Reply> Attend(Worker& worker, short events);
  bool Hangs(Worker& worker, double waited) const;
  Reply TakeReply(Worker& worker, std::string answer);
  std::optional<Reply> Replace(Worker& worker, const std::string& cause);

  WorkerPoolOptions options_;
  Work work_;
  int wake_ = -1;
  std::vector<Worker> workers_;
  std::deque<Request> waiting_;
  std::optional<std::string> failure_;
};

}  // namespace plsc
