#pragma once

// Tells a worker that hangs from one that merely takes long. Not by the clock:
// a laptop sleeps, a batch system stops its jobs, a machine has more to do, and
// none of this is the worker's fault. What counts is the time that was its own:
// the CPU time that it used, and the time in which it did nothing of its own
// accord while its owner was awake and waiting: evaluations only compute, so
// they have no reason to sleep, and a stop that is not meant for all of the run
// is one that nobody may ever end.

#include <sys/types.h>

#include <optional>

namespace plsc {

/// How a process fares.
struct Vitals {
  double cpu = 0;  ///< s that it computed, ever; in steps of 10 ms
  /// Waits for something that may never come, SIGCONT after a SIGSTOP
  /// included. Not so one that a debugger holds, that waits for a disk, or for
  /// its turn on a core.
  bool is_idle = false;
};

/// Nothing where there is no such process, or no /proc.
std::optional<Vitals> ReadVitals(pid_t pid);

class WorkerWatch {
 public:
  WorkerWatch() = default;
  /// Begins with a request.
  explicit WorkerWatch(const std::optional<Vitals>& vitals)
      : cpu_(vitals ? vitals->cpu : 0) {}

  /// The owner has waited for `waited` s more, at the end of which the worker
  /// looked like this. Without vitals all waiting counts.
  void Add(double waited, const std::optional<Vitals>& vitals);
  /// s that the worker had for itself since its request began.
  double own_seconds() const { return computed_ + idle_; }

 private:
  double cpu_ = 0;       // at the last look
  double computed_ = 0;  // since the request began
  double idle_ = 0;
};

}  // namespace plsc
