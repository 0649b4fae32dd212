#pragma once

// Pipes that their reader left, as outputs.

#include <csignal>

namespace plsc::cli {

/// While it lives, writing to such a pipe fails and says so; it is no signal
/// that ends the program.
class PipeErrors {
 public:
  PipeErrors() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
  ~PipeErrors() { std::signal(SIGPIPE, before_); }
  PipeErrors(const PipeErrors&) = delete;
  PipeErrors& operator=(const PipeErrors&) = delete;

 private:
  void (*before_)(int);
};

}  // namespace plsc::cli
