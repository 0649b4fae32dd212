#include "runtime/report/chart_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "grammar/number.h"

namespace plsc {

std::vector<double> RoundTicks(double low, double high, int count) {
  if (!(low < high)) return {};
  const double rough = (high - low) / count;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double digit : {5.0, 2.0, 1.0})
    if (digit * power >= rough) step = digit * power;
  std::vector<double> ticks;
  // By whole numbers of steps: sums of a step would not end at a round number.
  for (double i = std::ceil(low / step); i * step <= high; ++i)
    ticks.push_back(i == 0 ? 0 : i * step);
  return ticks;
}

ChartScale ScaleOf(const std::vector<double>& values, double from, double to) {
  constexpr double kRoom = 0.05;  // of the range
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ChartScale scale{kInfinity, -kInfinity, from, to};
  for (const double value : values)
    if (std::isfinite(value)) {
      scale.low = std::min(scale.low, value);
      scale.high = std::max(scale.high, value);
    }
  if (scale.low > scale.high) {
    scale.low = 0;
    scale.high = 1;
  }
  double room = kRoom * (scale.high - scale.low);
  // All are the same.
  if (room == 0) room = scale.high == 0 ? 1 : std::abs(scale.high) / 2;
  scale.low -= room;
  scale.high += room;
  return scale;
}

std::string ChartGrid(const ChartScale& y, double left, double right) {
  constexpr int kTicks = 5;
  constexpr int kDigits = 6;  // a step's rounding error has more
  std::string svg;
  for (const double tick : RoundTicks(y.low, y.high, kTicks))
    svg += fmt::format(R"(<path d="M{:.1f} {:.1f}H{:.1f}" class="grid"/>)"
                       R"(<text x="{:.1f}" y="{:.1f}" class="tick">{}</text>)"
                       "\n",
                       left, y(tick), right, left - 6, y(tick) + 4,
                       PrintRoundedNumber(tick, kDigits));
  return svg;
}

}  // namespace plsc
