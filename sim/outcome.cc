#include "sim/outcome.h"

#include <cassert>

namespace plsc {

std::string_view OutcomeName(Outcome outcome) {
  switch (outcome) {
    case Outcome::kCompleted:
      return "completed";
    case Outcome::kOverlapping:
      return "overlapping";
    case Outcome::kUndeveloped:
      return "undeveloped";
    case Outcome::kUnstable:
      return "unstable";
    case Outcome::kWorkerDied:
      return "worker_died";
    case Outcome::kFellThrough:
      return "fell_through";
    case Outcome::kSolverFailed:
      return "solver_failed";
    case Outcome::kOutOfSteps:
      return "out_of_steps";
    case Outcome::kTooLarge:
      return "too_large";
    case Outcome::kNotReached:
      return "not_reached";
    case Outcome::kStopped:
      return "stopped";
  }
  assert(false);
  return "";
}

}  // namespace plsc
