#pragma once

// A pool of worker processes that answer requests, texts both. Processes and
// not threads, because a robot that crashes the physics must not end the run:
// docs/decisions/0002-workers-are-processes.md. Knows neither genotypes nor
// evaluations.

#include <sys/types.h>

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace plsc {

/// Runs in a worker. What it throws, or a crash, ends the worker.
using Work = std::function<std::string(const std::string& request)>;

struct Reply {
  int ticket = 0;
  std::optional<std::string> answer;  ///< nothing: two workers died on it
  std::string death;                  ///< of the second, "signal 11"
};

/// Workers are forked from the thread that makes the pool, which must be the
/// only one; they die with it. Whoever made the pool also uses it.
class WorkerPool {
 public:
  WorkerPool(int workers, Work work);
  ~WorkerPool();  ///< ends all workers at once, busy or not
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Requests are begun in the order of submission.
  void Submit(int ticket, std::string request);
  /// Forgets requests that no worker has begun.
  void CancelWaiting();
  /// Waits for replies, at most `timeout_ms` or until a signal comes. In the
  /// order of arrival, which is not that of submission.
  std::vector<Reply> Wait(int timeout_ms);

  int workers() const { return static_cast<int>(workers_.size()); }
  int busy() const;
  /// Requests without a reply: begun or waiting.
  int outstanding() const { return busy() + static_cast<int>(waiting_.size()); }
  /// Why there are no workers any more; then nothing will be answered.
  const std::optional<std::string>& failure() const { return failure_; }

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
