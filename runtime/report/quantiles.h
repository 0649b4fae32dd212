#pragma once

// Order statistics as R has them by default, so that figures compare with the
// paper's, which were made in R.

#include <vector>

namespace plsc {

/// The quantile of `share` (0 to 1) of `values`, which are sorted and not
/// empty: R's type 7, linear between order statistics.
double Quantile(const std::vector<double>& values, double share);

/// Without values no number.
double MeanOf(const std::vector<double>& values);

/// The three quartiles; without values, three that are no numbers.
struct Quartiles {
  double low = 0;
  double median = 0;
  double high = 0;
};
Quartiles QuartilesOf(std::vector<double> values);

/// A box plot's numbers: whiskers end at the farthest values within 1.5 times
/// the box from it (Tukey), and all beyond them are outliers.
struct BoxPlot {
  Quartiles quartiles;
  double low_whisker = 0;
  double high_whisker = 0;
  double mean = 0;
  std::vector<double> outliers;  ///< ascending
};
/// Of values that are there at all.
BoxPlot BoxPlotOf(std::vector<double> values);

}  // namespace plsc
