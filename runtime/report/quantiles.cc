// R's type 7, its default and the paper's: the quantile lies at share * (n - 1)
// of the sorted values, between neighbours in proportion. Whiskers reach to the
// last value within one and a half boxes (Tukey), as in R's boxplot.

#include "runtime/report/quantiles.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace plsc {

namespace {

// Of the height of the box; Tukey's, and the default of R and of most others.
constexpr double kReach = 1.5;

Quartiles OfSorted(const std::vector<double>& values) {
  if (values.empty()) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    return {kNan, kNan, kNan};
  }
  return {Quantile(values, 0.25), Quantile(values, 0.5),
          Quantile(values, 0.75)};
}

}  // namespace

double Quantile(const std::vector<double>& values, double share) {
  assert(!values.empty());
  const double place = share * static_cast<double>(values.size() - 1);
  const double below = std::floor(place);
  const auto index = static_cast<std::size_t>(below);
  if (index + 1 >= values.size()) return values.back();
  return values[index] + (place - below) * (values[index + 1] - values[index]);
}

double MeanOf(const std::vector<double>& values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(values.size());
}

Quartiles QuartilesOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return OfSorted(values);
}

BoxPlot BoxPlotOf(std::vector<double> values) {
  assert(!values.empty());
  std::sort(values.begin(), values.end());
  BoxPlot box;
  box.quartiles = OfSorted(values);
  const double reach = kReach * (box.quartiles.high - box.quartiles.low);
  const double low = box.quartiles.low - reach;
  const double high = box.quartiles.high + reach;
  box.low_whisker = *std::lower_bound(values.begin(), values.end(), low);
  box.high_whisker =
      *std::prev(std::upper_bound(values.begin(), values.end(), high));
  for (const double value : values)
    if (value < low || value > high) box.outliers.push_back(value);
  box.mean = MeanOf(values);
  return box;
}

}  // namespace plsc
