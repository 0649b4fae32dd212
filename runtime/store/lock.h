#pragma once

// Who works on a run: one process at most. A lock of the system (fcntl) on a
// file beside the store, RUN.lock, which goes with the process however it
// ends. Readers need none. See docs/decisions/0008-runs-are-sqlite-files.md.

#include <optional>
#include <string>

namespace plsc {

class RunLock {
 public:
  RunLock() = default;
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  /// What went wrong: "'run.sqlite' is in use by process 17 on host"; or
  /// nothing. Does not refuse the very process that holds it.
  std::optional<std::string> Take(const std::string& run);
  void Release();  ///< and removes the file

 private:
  int descriptor_ = -1;
  int owner_ = 0;  // pid; a fork's copy must not remove the file
  std::string path_;
};

/// "process 17 on host", if another process works on the run now. Not to be
/// asked by the process that does: it would lose its lock (as POSIX has it).
std::optional<std::string> WhoWorksOn(const std::string& run);

}  // namespace plsc
