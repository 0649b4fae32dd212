#include "sim/outcome.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("Outcomes have the names that results use", "[outcome]") {
  CHECK(OutcomeName(Outcome::kCompleted) == "completed");
  CHECK(OutcomeName(Outcome::kOverlapping) == "overlapping");
  CHECK(OutcomeName(Outcome::kUndeveloped) == "undeveloped");
  CHECK(OutcomeName(Outcome::kUnstable) == "unstable");
  CHECK(OutcomeName(Outcome::kFellThrough) == "fell_through");
  CHECK(OutcomeName(Outcome::kSolverFailed) == "solver_failed");
  CHECK(OutcomeName(Outcome::kOutOfSteps) == "out_of_steps");
  CHECK(OutcomeName(Outcome::kTooLarge) == "too_large");
  CHECK(OutcomeName(Outcome::kNotReached) == "not_reached");
  CHECK(OutcomeName(Outcome::kStopped) == "stopped");
}

}  // namespace
}  // namespace plsc
