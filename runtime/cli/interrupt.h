#pragma once

// Ctrl-C for commands that take long: instead of ending the process it is
// remembered, and the command asks and ends by itself, with what was done kept
// and Exit::kInterrupted.

#include <csignal>

namespace plsc::cli {

/// Takes SIGINT and SIGTERM for as long as it lives; one at a time. A second
/// signal ends the program at once, as without us.
class InterruptHandler {
 public:
  InterruptHandler();
  ~InterruptHandler();
  InterruptHandler(const InterruptHandler&) = delete;
  InterruptHandler& operator=(const InterruptHandler&) = delete;

  /// Whether a signal came since the latest handler was made.
  static bool is_interrupted();

 private:
  struct sigaction old_int_ {};
  struct sigaction old_term_ {};
};

}  // namespace plsc::cli
