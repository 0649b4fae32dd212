#include "sim/outcome.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("Outcomes have the names that results use", "[outcome]") {
  CHECK(OutcomeName(Outcome::kCompleted) == "completed");
  CHECK(OutcomeName(Outcome::kOverlapping) == "overlapping");
  CHECK(OutcomeName(Outcome::kUndeveloped) == "undeveloped");
  CHECK(OutcomeName(Outcome::kUnstable) == "unstable");
}

}  // namespace
}  // namespace plsc
