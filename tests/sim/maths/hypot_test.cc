#include "sim/maths/hypot.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/sim/maths/ulps.h"

namespace plsc {
namespace {

using test::IsSame;
using test::Ulps;

TEST_CASE("Roots of two squares are right to half a last place", "[maths]") {
  test::Arguments arguments(7);
  test::Worst worst;
  const auto add = [&](double a, double b) {
    worst.Add(
        Hypot(a, b),
        std::hypot(static_cast<long double>(a), static_cast<long double>(b)),
        a);
  };
  for (int i = 0; i < 500'000; ++i) {
    const double a = arguments.Between(-1, 1);
    add(a, arguments.Between(-1, 1));
    const double far = arguments.OfExponent(-1000, 1000);
    add(far, far * arguments.OfExponent(-20, 20));
  }
  CAPTURE(worst.at);
  CHECK(worst.most < 0.51);
}

TEST_CASE("Roots of special values are those of C", "[maths]") {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double most = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  CHECK(Hypot(3, -4) == 5);
  CHECK(IsSame(Hypot(-0.0, -0.0), 0.0));
  CHECK(Hypot(-2, 0) == 2);
  CHECK(Hypot(0, tiny) == tiny);
  CHECK(Hypot(3 * tiny, 4 * tiny) == 5 * tiny);
  CHECK(Hypot(most, 0) == most);
  CHECK(Hypot(most / 2, most / 2) == std::hypot(most / 2, most / 2));
  CHECK(Hypot(most, most) == infinity);
  CHECK(Hypot(1, 1e-200) == 1);
  CHECK(Hypot(1e-200, 3e-200) > 3e-200);
  for (const double x : {0.0, 1.0, infinity, nan}) {
    CHECK(Hypot(x, -infinity) == infinity);
    CHECK(Hypot(infinity, x) == infinity);
    CHECK(std::isnan(Hypot(x, nan)) == (x != infinity));
  }
}

}  // namespace
}  // namespace plsc
