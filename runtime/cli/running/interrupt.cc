// A signal may come between any two instructions, so its handler sets a flag
// and nothing else. It is set once: a second Ctrl-C finds the system's own way
// and ends the program at once, for whoever does not want to wait.

#include "runtime/cli/running/interrupt.h"

namespace plsc::cli {

namespace {

volatile std::sig_atomic_t interrupted = 0;
int handlers = 0;  // that live

}  // namespace

InterruptHandler::InterruptHandler() {
  if (handlers++ == 0) interrupted = 0;
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted = 1; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  ::sigaction(SIGINT, &action, &old_int_);
  ::sigaction(SIGTERM, &action, &old_term_);
}

InterruptHandler::~InterruptHandler() {
  --handlers;
  ::sigaction(SIGINT, &old_int_, nullptr);
  ::sigaction(SIGTERM, &old_term_, nullptr);
}

bool InterruptHandler::is_interrupted() {
  return interrupted != 0;
}

}  // namespace plsc::cli
