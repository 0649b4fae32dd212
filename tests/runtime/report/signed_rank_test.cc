#include "runtime/report/signed_rank.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

namespace plsc {
namespace {

/// By all 2^n signs, an independent way.
double PByEnumeration(const std::vector<double>& values) {
  std::vector<double> sizes;
  for (const double value : values)
    if (value != 0) sizes.push_back(std::abs(value));
  const auto rank = [&](double size) {
    double below = 0;
    double equal = 0;
    for (const double other : sizes) {
      below += other < size ? 1 : 0;
      equal += other == size ? 1 : 0;
    }
    return below + (equal + 1) / 2;
  };
  double seen = 0;
  for (const double value : values)
    if (value > 0) seen += rank(value);
  const unsigned ways = 1U << sizes.size();
  double low = 0;
  double high = 0;
  for (unsigned signs = 0; signs < ways; ++signs) {
    double sum = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i)
      if ((signs >> i & 1U) != 0) sum += rank(sizes[i]);
    low += sum <= seen ? 1 : 0;
    high += sum >= seen ? 1 : 0;
  }
  return std::min(1.0, 2 * std::min(low, high) / ways);
}

TEST_CASE("V and p are R's", "[report]") {
  // wilcox.test(c(1.1, -0.4, 2.3, 0.7, 1.9, -0.2, 3.1, 0.9)): V = 33
  const auto mixed = SignedRankTest({1.1, -0.4, 2.3, 0.7, 1.9, -0.2, 3.1, 0.9});
  REQUIRE(mixed);
  CHECK(mixed->v == 33);
  CHECK(mixed->p == Approx(0.0390625).epsilon(1e-14));
  // All of ten above 0: 2 / 2^10.
  const auto above = SignedRankTest({1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  CHECK(above->v == 55);
  CHECK(above->p == Approx(0.001953125).epsilon(1e-14));
  CHECK(SignedRankTest({-1})->p == 1);
}

TEST_CASE("zeros say nothing", "[report]") {
  CHECK_FALSE(SignedRankTest({}));
  CHECK_FALSE(SignedRankTest({0, 0}));
  CHECK(SignedRankTest({0, 1, 2, 0, 3})->p == SignedRankTest({1, 2, 3})->p);
}

TEST_CASE("ties have the p of all ways to sign them", "[report]") {
  const unsigned seed = 20;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 40; ++i) {
    std::vector<double> values(1 + random() % 10);
    for (double& value : values)
      value = static_cast<double>(static_cast<int>(random() % 9) - 4);
    const auto result = SignedRankTest(values);
    if (result)
      CHECK(result->p == Approx(PByEnumeration(values)).epsilon(1e-12));
  }
}

TEST_CASE("many values are counted, too", "[report]") {
  std::vector<double> values;
  for (int i = 1; i <= 100; ++i) values.push_back(i % 3 == 0 ? -i : i);
  const auto result = SignedRankTest(values);
  CHECK(result->p > 0);
  // R's normal approximation: V = 3367, z = 2.8935 with correction.
  CHECK(result->v == 3367);
  CHECK(result->p == Approx(0.0038).epsilon(0.1));
}

}  // namespace
}  // namespace plsc
