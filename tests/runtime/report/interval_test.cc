#include "runtime/report/interval.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/runtime/report/r_rows.h"

namespace plsc {

TEST_CASE("Limits of a share are those of R's binom.test", "[interval]") {
  for (const test::RRow& row : test::RRows("share")) {
    const auto hits = static_cast<std::size_t>(row.x[0]);
    const auto count = static_cast<std::size_t>(row.y[0]);
    INFO(hits << " of " << count);
    const Interval interval = ShareInterval(hits, count);
    CHECK(interval.low == Approx(row.numbers[1]).epsilon(1e-12).margin(0));
    CHECK(interval.high == Approx(row.numbers[2]).epsilon(1e-12).margin(0));
  }
}

TEST_CASE("Percentiles are the outer quantiles of what there is",
          "[interval]") {
  std::vector<double> replicates;
  for (int i = 1000; i >= 0; --i) replicates.push_back(i);
  CHECK(PercentileInterval(replicates) == Interval{25, 975});
}

// By hand: z0 is the normal quantile of the share below, and without skewness
// the shares are P(2 z0 - 1.96) and P(2 z0 + 1.96).
TEST_CASE("BCa moves with the replicates that lie below the estimate",
          "[interval]") {
  std::vector<double> replicates;
  for (int i = 0; i <= 10'000; ++i) replicates.push_back(i);
  const std::vector<std::vector<double>> even = {{1, 2, 3}};
  const Interval middle = BcaInterval(replicates, 5000, even);
  CHECK(middle.low == Approx(250).margin(0.01));
  CHECK(middle.high == Approx(9750).margin(0.01));
  // pnorm(2 * qnorm(0.6) + c(-1, 1) * qnorm(0.975)) of R, of 10,000
  const Interval above = BcaInterval(replicates, 6000, even);
  CHECK(above.low == Approx(730.74).margin(0.5));
  CHECK(above.high == Approx(9931.81).margin(0.5));
  // All to one side: as they are.
  CHECK(BcaInterval(replicates, -1, even) == PercentileInterval(replicates));
}

TEST_CASE("BCa moves with the skewness of what values contribute",
          "[interval]") {
  std::vector<double> replicates;
  for (int i = 0; i <= 10'000; ++i) replicates.push_back(i);
  // Influences -2/3, -2/3 and 4/3: a = (64 - 16) / 27 / 6 / (24 / 9)^1.5.
  const Interval skewed = BcaInterval(replicates, 5000, {{1, 1, 0}});
  const double a = 48.0 / 27 / 6 / std::pow(24.0 / 9, 1.5);
  const auto share = [&](double z) {
    return 10'000 * std::erfc(-z / (1 - a * z) / std::sqrt(2.0)) / 2;
  };
  constexpr double kZ = 1.959963984540054;
  CHECK(skewed.low == Approx(share(-kZ)).margin(0.5));
  CHECK(skewed.high == Approx(share(kZ)).margin(0.5));
  CHECK(skewed.low > 250);
}

}  // namespace plsc
