#include "sim/maths/exponential.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/sim/maths/ulps.h"

namespace plsc {
namespace {

using test::IsSame;
using test::kInfinity;
using test::kNaN;
using test::Ulps;

TEST_CASE("Exponentials are right to nine tenths of a last place", "[maths]") {
  test::Arguments arguments(5);
  test::Worst worst;
  const auto add = [&](double x) {
    worst.Add(Exp(x), std::exp(static_cast<long double>(x)), x);
  };
  for (int i = 0; i < 400'000; ++i) {
    add(arguments.Between(-1, 1));
    add(arguments.Between(-746, 710));
    add(arguments.OfExponent(-60, 9));
  }
  CAPTURE(worst.at);
  CHECK(worst.most < 0.9);
}

TEST_CASE("Exponentials of special values are those of C", "[maths]") {
  CHECK(Exp(0) == 1);
  CHECK(Exp(-0.0) == 1);
  CHECK(Exp(1e-300) == 1);
  CHECK(Exp(1) == 0x1.5bf0a8b145769p+1);
  CHECK(IsSame(Exp(-kInfinity), 0.0));
  CHECK(IsSame(Exp(-1e300), 0.0));
  CHECK(Exp(kInfinity) == kInfinity);
  CHECK(Exp(1e300) == kInfinity);
  CHECK(std::isnan(Exp(kNaN)));
  // The last that are numbers, and not 0.
  CHECK(Ulps(Exp(0x1.62e42fefa39efp+9), std::exp(0x1.62e42fefa39efp+9L)) < 0.9);
  CHECK(Exp(0x1.62e42fefa39f0p+9) == kInfinity);
  CHECK(Exp(-0x1.74910d52d3051p+9) ==
        std::numeric_limits<double>::denorm_min());
  CHECK(IsSame(Exp(-0x1.74910d52d3052p+9), 0.0));
}

TEST_CASE("Logarithms are right to nine tenths of a last place", "[maths]") {
  test::Arguments arguments(6);
  test::Worst worst;
  const auto add = [&](double x) {
    worst.Add(Log(x), std::log(static_cast<long double>(x)), x);
  };
  for (int i = 0; i < 400'000; ++i) {
    add(arguments.Between(0, 2));
    add(std::fabs(arguments.OfExponent(-1022, 1023)));
    add(1 + arguments.OfExponent(-52, -2));
  }
  CAPTURE(worst.at);
  CHECK(worst.most < 0.9);
}

TEST_CASE("Logarithms of special values are those of C", "[maths]") {
  CHECK(IsSame(Log(1), 0.0));
  CHECK(Log(2) == 0x1.62e42fefa39efp-1);
  CHECK(Log(0.0) == -kInfinity);
  CHECK(Log(-0.0) == -kInfinity);
  CHECK(Log(kInfinity) == kInfinity);
  for (const double x : {-1.0, -1e-310, -kInfinity, kNaN})
    CHECK(std::isnan(Log(x)));
  for (const double x : {std::numeric_limits<double>::denorm_min(), 1e-310,
                         0x1p-1022, std::numeric_limits<double>::max()})
    CHECK(Ulps(Log(x), std::log(static_cast<long double>(x))) < 0.9);
}

TEST_CASE("Exponential and logarithm do not jump where intervals meet",
          "[maths]") {
  // Half of log 2 on both sides, and the root of two by powers of it.
  for (const double end :
       {-0x1.62e42fefa39efp-2, 0x1.62e42fefa39efp-2, 1.0397207708399179,
        0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bcdp+0, 1.0, 2.0, 100.0}) {
    double x = end;
    for (int i = 0; i < 500; ++i) x = std::nextafter(x, -kInfinity);
    for (int i = 0; i < 1000; ++i) {
      const double next = std::nextafter(x, kInfinity);
      if (Exp(next) < Exp(x)) FAIL(x);
      if (x > 0 && Log(next) < Log(x)) FAIL(x);
      x = next;
    }
  }
}

}  // namespace
}  // namespace plsc
