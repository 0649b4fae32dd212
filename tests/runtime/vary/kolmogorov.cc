#include "tests/runtime/vary/kolmogorov.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace plsc::test {

double KolmogorovPValue(std::vector<double> sample,
                        const std::function<double(double)>& cdf) {
  assert(sample.size() >= 40);
  std::sort(sample.begin(), sample.end());
  const auto n = static_cast<double>(sample.size());
  double distance = 0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double expected = cdf(sample[i]);
    const auto below = static_cast<double>(i);
    distance =
        std::max({distance, expected - below / n, (below + 1) / n - expected});
  }
  const double x = std::sqrt(n) * distance;
  // The alternating series converges within a few terms where x is not tiny;
  // where it is, the probability is 1 to many digits.
  if (x < 0.3) return 1;
  double sum = 0;
  for (int k = 1; k <= 100; ++k)
    sum += (k % 2 == 1 ? 2 : -2) * std::exp(-2 * k * k * x * x);
  return std::clamp(sum, 0.0, 1.0);
}

double UniformCdf(double x, double low, double high) {
  return std::clamp((x - low) / (high - low), 0.0, 1.0);
}

double NormalCdf(double x) {
  return std::erfc(-x / std::sqrt(2.0)) / 2;
}

}  // namespace plsc::test
