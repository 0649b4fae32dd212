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
  }
  assert(false);
  return "";
}

}  // namespace plsc
