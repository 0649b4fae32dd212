#include "sim/maths/sine.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/sim/maths/ulps.h"

namespace plsc {
namespace {

using test::IsSame;
using test::kInfinity;
using test::Ulps;

/// Of both functions, at n arguments.
template <typename Draw>
test::Worst WorstOf(int n, const Draw& draw) {
  test::Worst worst;
  for (int i = 0; i < n; ++i) {
    const double x = draw();
    worst.Add(Sin(x), std::sin(static_cast<long double>(x)), x);
    worst.Add(Cos(x), std::cos(static_cast<long double>(x)), x);
  }
  return worst;
}

TEST_CASE("Sines and cosines are right to nine tenths of a last place",
          "[maths]") {
  test::Arguments arguments(1);
  // x87 reduces arguments up to 2^63.
  const test::Worst worst[] = {
      WorstOf(300'000, [&] { return arguments.Between(-0.8, 0.8); }),
      WorstOf(300'000, [&] { return arguments.Between(-7, 7); }),
      WorstOf(200'000, [&] { return arguments.Between(-1.1e6, 1.1e6); }),
      WorstOf(200'000, [&] { return arguments.OfExponent(-40, 61); })};
  for (const test::Worst& one : worst) {
    CAPTURE(one.at);
    CHECK(one.most < 0.9);
  }
}

TEST_CASE("Arguments near multiples of a quarter turn are reduced exactly",
          "[maths]") {
  test::Worst worst;
  // Those that come closest, of all below 2^20.
  for (const double x : {0x1.6c6cbc45dc8dep+5, 0x1.6c6cbc45dc8dep+11,
                         0x1.39c6fd67805a7p+18, 0x1.39c6fd67805a7p+19}) {
    worst.Add(Sin(x), std::sin(static_cast<long double>(x)), x);
    worst.Add(Cos(x), std::cos(static_cast<long double>(x)), x);
  }
  for (int n = -100'000; n < 100'000; ++n) {
    const double near = n * 0x1.921fb54442d18p+0;
    for (const double x : {near, std::nextafter(near, kInfinity),
                           std::nextafter(near, -kInfinity)}) {
      worst.Add(Sin(x), std::sin(static_cast<long double>(x)), x);
      worst.Add(Cos(x), std::cos(static_cast<long double>(x)), x);
    }
  }
  CAPTURE(worst.at);
  CHECK(worst.most < 0.9);
}

TEST_CASE("Arguments of any size are reduced exactly", "[maths]") {
  struct Row {
    double x;
    double sine;
    double cosine;
  };
  // With 400 digits, rounded; the first is of all doubles the closest to a
  // multiple of a quarter turn (Muller, Elementary Functions, 11.3).
  const Row rows[] = {
      {0x1.6ac5b262ca1ffp+849, 0x1.0000000000000p+0, -0x1.14ae72e6ba22fp-61},
      {0x1.0f0cf064dd592p+73, -0x1.b453ab76bf397p-1, 0x1.0be2cef01c8f4p-1},
      {0x1.0000000000000p+20, 0x1.526ccb2fc8656p-2, 0x1.e33ada92fe2aep-1},
      {0x1.0000100000000p+20, 0x1.f20cc1ff62d21p-1, 0x1.dacfb27d45b34p-3},
      {0x1.0000000000001p+52, 0x1.053c35068e10dp-4, -0x1.fef526a39c993p-1},
      {0x1.7e43c8800759cp+996, -0x1.a2c16b010e385p-1, -0x1.2699022adc4c1p-1},
      {0x1.fffffffffffffp+1023, 0x1.452fc98b34e97p-8, -0x1.fffe62ecfab75p-1},
      {0x1.0000000000000p+1000, -0x1.460b8ae1c886ep-3, 0x1.f9785160c8815p-1},
      {0x1.6ac5b262ca1ffp+849, 0x1.0000000000000p+0, -0x1.14ae72e6ba22fp-61},
      {0x1.c12218377de40p+46, -0x1.328335789c9f5p-1, 0x1.9a1d5ce51008fp-1},
  };
  for (const Row& row : rows) {
    CAPTURE(row.x);
    CHECK(Ulps(Sin(row.x), row.sine) <= 1);
    CHECK(Ulps(Cos(row.x), row.cosine) <= 1);
    CHECK(IsSame(Sin(-row.x), -Sin(row.x)));
    CHECK(IsSame(Cos(-row.x), Cos(row.x)));
  }
}

TEST_CASE("Both at once are each alone", "[maths]") {
  test::Arguments arguments(2);
  for (int i = 0; i < 20'000; ++i) {
    const double small = arguments.Between(-4, 4);
    for (const double x : {small, arguments.OfExponent(-1022, 1023)}) {
      const SineCosine both = SinCos(x);
      const bool is_same =
          IsSame(both.sine, Sin(x)) && IsSame(both.cosine, Cos(x));
      if (!is_same) FAIL(x);
    }
  }
}

TEST_CASE("Sines of special values", "[maths]") {
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const double x : {0.0, -0.0, tiny, -tiny, 0x1p-1022, 0x1p-30}) {
    CAPTURE(x);
    CHECK(IsSame(Sin(x), x));
    CHECK(Cos(x) == 1);
    CHECK(IsSame(SinCos(x).sine, x));
  }
  for (const double x :
       {kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(std::isnan(Sin(x)));
    CHECK(std::isnan(Cos(x)));
    CHECK(std::isnan(SinCos(x).sine));
  }
  CHECK(Sin(0x1.921fb54442d18p+0) == 1);
  CHECK(Cos(0x1.921fb54442d18p+1) == -1);
}

TEST_CASE("Sine and cosine do not jump where intervals meet", "[maths]") {
  // The ends of the reduction, and of what is not reduced.
  for (const double end :
       {0x1p-27, 0.78, 0x1.921fb54442d18p-1, 1.5, 2.356, 3.14, 0x1p20}) {
    const bool is_rising = Sin(end * (1 + 1e-12)) > Sin(end * (1 - 1e-12));
    double x = end;
    for (int i = 0; i < 500; ++i) x = std::nextafter(x, 0);
    for (int i = 0; i < 1000; ++i) {
      const double next = std::nextafter(x, kInfinity);
      const double step = Sin(next) - Sin(x);
      if (is_rising ? step < 0 : step > 0) FAIL(x);
      x = next;
    }
  }
}

}  // namespace
}  // namespace plsc
