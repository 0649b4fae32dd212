#pragma once

// Those who answer requests, texts both: what a run needs to know of its
// workers, wherever they are. Forked on this machine (worker_pool.h), or by the
// ranks of an MPI job on many (mpi_session.h). Knows neither genotypes nor
// evaluations.

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
  /// How the second died: "signal 11", "exit status 2", "no answer for 600 s".
  std::string death;
};

/// Used by one thread, the one that made it.
class Workers {
 public:
  Workers() = default;
  virtual ~Workers() = default;  ///< ends all at once, busy or not
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Requests are begun in the order of submission. Tickets differ among those
  /// that are outstanding.
  virtual void Submit(int ticket, std::string request) = 0;
  /// Forgets requests that no worker has begun; they get no reply. Those that
  /// wait on other machines stay outstanding until a Wait has received word of
  /// them.
  virtual void CancelWaiting() = 0;
  /// Waits for replies, at most `timeout_ms` or until a signal comes; may come
  /// back earlier with none. In the order of arrival, which is not that of
  /// submission.
  virtual std::vector<Reply> Wait(int timeout_ms) = 0;

  virtual int workers() const = 0;
  virtual int busy() const = 0;
  /// Requests without a reply: begun or waiting.
  virtual int outstanding() const = 0;
  /// Why there are no workers any more; then nothing will be answered.
  virtual const std::optional<std::string>& failure() const = 0;
};

}  // namespace plsc
