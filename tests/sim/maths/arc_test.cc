#include "sim/maths/arc.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/sim/maths/ulps.h"

namespace plsc {
namespace {

using test::IsSame;
using test::kInfinity;
using test::kNaN;
using test::Ulps;

constexpr double kPi = 0x1.921fb54442d18p+1;

TEST_CASE("Arc tangents are right to two thirds of a last place", "[maths]") {
  test::Arguments arguments(3);
  test::Worst worst;
  const auto add = [&](double y, double x) {
    worst.Add(
        Atan2(y, x),
        std::atan2(static_cast<long double>(y), static_cast<long double>(x)),
        y / x);
  };
  for (int i = 0; i < 400'000; ++i) {
    const double y = arguments.Between(-1, 1);
    add(y, arguments.Between(-1, 1));
    // Of all magnitudes, alike and not.
    const double far = arguments.OfExponent(-1022, 1023);
    add(far, arguments.OfExponent(-1022, 1023));
    add(far,
        std::clamp(far * arguments.OfExponent(-40, 40), -0x1p1023, 0x1p1023));
  }
  CAPTURE(worst.at);
  CHECK(worst.most < 0.67);
}

TEST_CASE("Arc tangents of special points are those of C", "[maths]") {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const double values[] = {
      0.0,       tiny,   0x1p-1030,
      0x1p-1022, 1e-300, 1,
      3,         1e300,  std::numeric_limits<double>::max(),
      kInfinity};
  for (const double a : values)
    for (const double b : values)
      for (const double y : {a, -a})
        for (const double x : {b, -b}) {
          CAPTURE(y, x);
          const auto want = std::atan2(static_cast<long double>(y),
                                       static_cast<long double>(x));
          CHECK(Ulps(Atan2(y, x), want) < 0.67);
          CHECK(std::signbit(Atan2(y, x)) == std::signbit(y));
        }
  CHECK(IsSame(Atan2(0.0, -0.0), kPi));
  CHECK(IsSame(Atan2(-0.0, 0.0), -0.0));
  CHECK(IsSame(Atan2(5, 5), kPi / 4));
  CHECK(IsSame(Atan2(-1, 0), -kPi / 2));
  for (const double x : {0.0, 1.0, kInfinity, kNaN}) {
    CHECK(std::isnan(Atan2(kNaN, x)));
    CHECK(std::isnan(Atan2(x, kNaN)));
  }
}

TEST_CASE("Arc cosines are right to seven tenths of a last place", "[maths]") {
  test::Arguments arguments(4);
  test::Worst worst;
  const auto add = [&](double x) {
    worst.Add(Acos(x), std::acos(static_cast<long double>(x)), x);
  };
  for (int i = 0; i < 500'000; ++i) {
    add(arguments.Between(-1, 1));
    // Towards the ends, where the arc is a root.
    const double gap = std::fabs(arguments.OfExponent(-53, -1));
    add(i % 2 == 0 ? 1 - gap : gap - 1);
  }
  CAPTURE(worst.at);
  CHECK(worst.most < 0.7);
}

TEST_CASE("Arc cosines of special values", "[maths]") {
  CHECK(IsSame(Acos(1), 0.0));
  CHECK(IsSame(Acos(-1), kPi));
  CHECK(IsSame(Acos(0), kPi / 2));
  CHECK(IsSame(Acos(-0.0), kPi / 2));
  CHECK(IsSame(Acos(1e-320), kPi / 2));
  for (const double x : {std::nextafter(1, 2), -1.5, kInfinity, kNaN})
    CHECK(std::isnan(Acos(x)));
}

TEST_CASE("Arcs do not jump where intervals meet", "[maths]") {
  for (const double end :
       {0x1p-30, 0x1.a827999fcef32p-2, 1.0, 2.414213562373095, 0x1p30}) {
    double x = end;
    for (int i = 0; i < 500; ++i) x = std::nextafter(x, 0);
    for (int i = 0; i < 1000; ++i) {
      const double next = std::nextafter(x, kInfinity);
      if (Atan2(next, 1) < Atan2(x, 1)) FAIL(x);
      if (Atan2(next, -1) > Atan2(x, -1)) FAIL(-x);
      if (next <= 1 && Acos(next) > Acos(x)) FAIL(x);
      x = next;
    }
  }
}

}  // namespace
}  // namespace plsc
