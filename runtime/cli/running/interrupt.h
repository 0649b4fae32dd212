#pragma once

// Ctrl-C for commands that take long: instead of ending the process it is
// remembered, and the command asks and ends by itself, with what was done kept
// and Exit::kInterrupted.

#include <csignal>

namespace plsc::cli {

/// Takes SIGINT and SIGTERM for as long as it lives. A second signal ends the
/// program at once, as without us. One may live inside another, as a run inside
/// a study: then a signal that came between two runs is not forgotten.
class InterruptHandler {
 public:
  InterruptHandler();
  ~InterruptHandler();
  InterruptHandler(const InterruptHandler&) = delete;
  InterruptHandler& operator=(const InterruptHandler&) = delete;

  /// Whether a signal came since the outermost handler was made.
  static bool is_interrupted();

 private:
  struct sigaction old_int_ {};
  struct sigaction old_term_ {};
};

}  // namespace plsc::cli
