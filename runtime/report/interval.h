#pragma once

// 95 % confidence intervals: of a share, exactly, and of any statistic by what
// it is in samples drawn from the sample (bootstrap).

#include <cstddef>
#include <vector>

namespace plsc {

struct Interval {
  double low = 0;
  double high = 0;

  friend bool operator==(const Interval&, const Interval&) = default;
};

/// What an interval leaves out, at both ends together.
inline constexpr double kOutside = 0.05;

/// Of the probability that is behind `hits` of `count`, at least one, tosses;
/// Clopper and Pearson's, which covers 95 % or more for any of them.
Interval ShareInterval(std::size_t hits, std::size_t count);

/// Between the outer quantiles of a statistic's replicates.
Interval PercentileInterval(std::vector<double> replicates);

/// Bias-corrected and accelerated: as PercentileInterval, with shares that
/// allow for replicates that lie to one side of the estimate, and for a spread
/// that depends on it. `left_out`: by sample, the statistic without each of its
/// values in turn.
Interval BcaInterval(std::vector<double> replicates, double estimate,
                     const std::vector<std::vector<double>>& left_out);

}  // namespace plsc
