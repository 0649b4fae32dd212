#pragma once

// A chart's frame: a range of values as px, its ticks and their labels.

#include <string>
#include <vector>

namespace plsc {

/// Round numbers within [low, high], about `count` of them: multiples of 1, 2
/// or 5 times a power of ten. At least one where low < high.
std::vector<double> RoundTicks(double low, double high, int count);

/// From values to px, for both directions.
struct ChartScale {
  double low = 0;
  double high = 1;
  double from = 0;  ///< px, of `low`
  double to = 1;    ///< px, of `high`

  double operator()(double value) const {
    return from + (value - low) / (high - low) * (to - from);
  }
};

/// Of all that are numbers, with room at both ends; 0 to 1 without any.
ChartScale ScaleOf(const std::vector<double>& values, double from, double to);

/// Lines across a chart from `left` to `right` at the ticks of `y`, with labels
/// left of them.
std::string ChartGrid(const ChartScale& y, double left, double right);

}  // namespace plsc
