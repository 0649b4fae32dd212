#include "runtime/report/normal.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace plsc {

// Of R's pnorm and qnorm.
TEST_CASE("Shares and quantiles of the normal distribution are R's",
          "[normal]") {
  CHECK(NormalBelow(0) == 0.5);
  CHECK(NormalBelow(1.5) == Approx(0.93319279873114191).epsilon(1e-15));
  CHECK(NormalBelow(-10) == Approx(7.6198530241605269e-24).epsilon(1e-14));
  CHECK(NormalQuantile(0.975) == Approx(1.959963984540054).epsilon(1e-14));
  CHECK(NormalQuantile(0.5) == Approx(0).margin(1e-15));
  CHECK(NormalQuantile(1e-5) == Approx(-4.2648907939228256).epsilon(1e-13));
  CHECK(NormalQuantile(0) == -INFINITY);
  CHECK(NormalQuantile(1) == INFINITY);
}

}  // namespace plsc
