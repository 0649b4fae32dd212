#include "sim/height_field.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace plsc {
namespace {

TEST_CASE("Rough ground passes through the origin and keeps its bounds",
          "[height_field]") {
  for (const std::uint64_t seed : {1U, 2U, 77U}) {
    const HeightField field({seed, 0.03, 0.25});
    CHECK(field.At(0, 0).height == 0);
    double low = 0, high = 0, steepest = 0;
    for (double x = -3; x < 3; x += 0.037) {
      for (double y = -3; y < 3; y += 0.041) {
        const HeightField::Point point = field.At(x, y);
        low = std::min(low, point.height);
        high = std::max(high, point.height);
        steepest = std::max(steepest, std::hypot(point.slope_x, point.slope_y));
      }
    }
    CHECK(high <= field.bound());
    CHECK(-low <= field.bound());
    CHECK(high - low > 0.03);  // it is rough
    CHECK(high - low <= 0.06);
    CHECK(steepest <= field.steepest());
    CHECK(steepest > field.steepest() / 4);
  }
}

TEST_CASE("Slopes are those of the heights, without jumps", "[height_field]") {
  const HeightField field({5, 0.03, 0.25});
  constexpr double kStep = 1e-6;
  // Lattice lines among the places: 0, -0.25, 0.5.
  for (const double x : {-1.234, -0.25, 0.0, 0.1, 0.5, 2.71}) {
    for (const double y : {-0.77, -0.25, 0.0, 0.3, 0.5}) {
      INFO(x << ' ' << y);
      const HeightField::Point point = field.At(x, y);
      CHECK(point.slope_x == Approx((field.At(x + kStep, y).height -
                                     field.At(x - kStep, y).height) /
                                    (2 * kStep))
                                 .margin(1e-6));
      CHECK(point.slope_y == Approx((field.At(x, y + kStep).height -
                                     field.At(x, y - kStep).height) /
                                    (2 * kStep))
                                 .margin(1e-6));
    }
  }
}

TEST_CASE("Another seed is another ground, the same seed the same",
          "[height_field]") {
  const HeightField a({1, 0.03, 0.25}), b({1, 0.03, 0.25}), c({2, 0.03, 0.25});
  CHECK(a.At(0.4, 0.9).height == b.At(0.4, 0.9).height);
  CHECK(a.At(0.4, 0.9).height != c.At(0.4, 0.9).height);
}

}  // namespace
}  // namespace plsc
