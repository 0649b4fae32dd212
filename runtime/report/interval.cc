// Percentile and BCa intervals are those of Efron and Tibshirani (1993,
// chapters 13 and 14). BCa takes the quantiles of shares
//   P(z0 + (z0 + z) / (1 - a (z0 + z))),  z = -1.96 and 1.96,
// z0 from the share of replicates below the estimate (of those that are equal
// to it half, for statistics that have steps), a from the skewness of what each
// value contributes; of several samples each contributes by its size (Davison
// and Hinkley 1997, 5.3.2). Clopper and Pearson's limits are found by halving:
// the tail of a binomial distribution grows with its probability.

#include "runtime/report/interval.h"

#include <algorithm>
#include <cmath>

#include "runtime/report/normal.h"
#include "runtime/report/quantiles.h"

namespace plsc {

namespace {

/// Of `hits` or more of `count`.
double UpperTail(std::size_t hits, std::size_t count, double probability) {
  const auto n = static_cast<double>(count);
  double sum = 0;
  for (std::size_t i = hits; i <= count; ++i) {
    const auto k = static_cast<double>(i);
    sum += std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) -
                    std::lgamma(n - k + 1) + k * std::log(probability) +
                    (n - k) * std::log1p(-probability));
  }
  return sum;
}

/// The probability at which so many or more hits are one time in forty.
double LowerLimit(std::size_t hits, std::size_t count) {
  constexpr int kHalvings = 50;
  if (hits == 0) return 0;
  double low = 0;
  double high = 1;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (UpperTail(hits, count, middle) < kOutside / 2 ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// How skewed the contributions are.
double Acceleration(const std::vector<std::vector<double>>& left_out) {
  double cubes = 0;
  double squares = 0;
  for (const std::vector<double>& sample : left_out) {
    const auto n = static_cast<double>(sample.size());
    const double mean = MeanOf(sample);
    for (const double one : sample) {
      const double influence = (n - 1) * (mean - one) / n;
      squares += influence * influence;
      cubes += influence * influence * influence;
    }
  }
  return squares > 0 ? cubes / (6 * std::pow(squares, 1.5)) : 0;
}

}  // namespace

Interval ShareInterval(std::size_t hits, std::size_t count) {
  return {LowerLimit(hits, count), 1 - LowerLimit(count - hits, count)};
}

Interval PercentileInterval(std::vector<double> replicates) {
  std::sort(replicates.begin(), replicates.end());
  return {Quantile(replicates, kOutside / 2),
          Quantile(replicates, 1 - kOutside / 2)};
}

Interval BcaInterval(std::vector<double> replicates, double estimate,
                     const std::vector<std::vector<double>>& left_out) {
  std::sort(replicates.begin(), replicates.end());
  const auto [below, above] =
      std::equal_range(replicates.begin(), replicates.end(), estimate);
  const double share = static_cast<double>((below - replicates.begin()) +
                                           (above - replicates.begin())) /
                       (2 * static_cast<double>(replicates.size()));
  const double bias = NormalQuantile(share);
  // All on one side: there is no more to correct by.
  if (std::isinf(bias)) return PercentileInterval(std::move(replicates));
  const double acceleration = Acceleration(left_out);
  const auto at = [&](double outside) {
    const double z = bias + NormalQuantile(outside);
    return Quantile(replicates, NormalBelow(bias + z / (1 - acceleration * z)));
  };
  return {at(kOutside / 2), at(1 - kOutside / 2)};
}

}  // namespace plsc
