#include "runtime/study/claim.h"

#include <catch2/catch.hpp>

namespace plsc {

TEST_CASE("A claim prints as it is written by hand", "[claim]") {
  Claim claim;
  claim.name = "faster";
  claim.measure = "speed";
  claim.kind = ClaimKind::kValue;
  claim.experiments = {"level"};
  claim.seasons = {"flat"};
  claim.value = 3.63;
  claim.over_runs = OverRuns::kMean;
  CHECK(PrintClaims({claim}, 0) ==
        "faster:\n  measure: speed\n  season: flat\n  experiment: level\n"
        "  value: 3.63 cm/s\n  over_runs: mean\n");
  CHECK(PrintClaims({}, 2).empty());
}

}  // namespace plsc
