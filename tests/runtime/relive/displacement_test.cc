#include "runtime/relive/displacement.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

namespace plsc {
namespace {

TEST_CASE("starts are higher by up to 30 um, each by its own chance",
          "[relive]") {
  std::set<double> lifts;
  double most = 0;
  for (int id = 1; id <= 20; ++id)
    for (int n = 1; n <= 20; ++n)
      for (const Disturbance& start : DisplacedStarts(7, id, n, 2)) {
        CHECK(start.lift >= 0);
        CHECK(start.lift <= 30e-6);
        most = std::max(most, start.lift);
        lifts.insert(start.lift);
        Disturbance only_lifted;
        only_lifted.lift = start.lift;
        CHECK(start == only_lifted);
      }
  CHECK(lifts.size() == 20 * 20 * 2);
  CHECK(most > 29e-6);
}

TEST_CASE("a start is a function of seed, robot and life alone", "[relive]") {
  CHECK(DisplacedStarts(7, 3, 2, 3) == DisplacedStarts(7, 3, 2, 3));
  // More seasons change nothing of the first.
  CHECK(DisplacedStarts(7, 3, 2, 1)[0] == DisplacedStarts(7, 3, 2, 3)[0]);
  CHECK(DisplacedStarts(8, 3, 2, 1) != DisplacedStarts(7, 3, 2, 1));
  CHECK(DisplacedStarts(7, 2, 3, 1) != DisplacedStarts(7, 3, 2, 1));
}

}  // namespace
}  // namespace plsc
