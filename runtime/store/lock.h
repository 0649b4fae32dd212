#pragma once

// Who works on a run: one process at most, under whatever name it knows the
// file. A lock of the system on the store itself (an open file description
// lock, on bytes that SQLite does not use), which goes with the process however
// it ends. Readers need none. See docs/decisions/0008-runs-are-sqlite-files.md.

#include <optional>
#include <string>

#include "grammar/failure.h"
#include "runtime/store/file_id.h"

namespace plsc {

class RunLock {
 public:
  RunLock() = default;
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  /// What went wrong: "'run.sqlite' is in use by process 17 on host"; or
  /// nothing. This process must have no connection to the file yet: see
  /// Release.
  MaybeFailure Take(const std::string& run);
  /// Of a file that has no name yet, by a descriptor of it, which stays the
  /// caller's.
  MaybeFailure TakeNew(const std::string& run, int descriptor);
  /// Connections to the file must be closed: to close any descriptor of a file
  /// drops the locks that SQLite has on it.
  void Release();
  /// Whether it holds the lock on what the path means.
  bool IsOn(const std::string& run) const {
    return descriptor_ >= 0 && FileIdOf(run) == file_;
  }

 private:
  MaybeFailure Lock(const std::string& run);

  int descriptor_ = -1;
  FileId file_;
};

/// "process 17 on host", if a process works on the run now. To be asked by a
/// process that has no connection to it, or that holds the lock itself.
std::optional<std::string> WhoWorksOn(const std::string& run);

}  // namespace plsc
