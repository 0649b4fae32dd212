#include "tests/runtime/vary/chi_square.h"

#include <cassert>
#include <cmath>
#include <numeric>

namespace plsc::test {

// The upper regularised incomplete gamma function Q(degrees/2, x/2): by its
// series below a + 1, by its continued fraction (Lentz) above, where each
// converges fast.
double ChiSquareTail(double x, int degrees) {
  const double a = degrees / 2.0;
  const double y = x / 2;
  if (y <= 0) return 1;
  const double scale = std::exp(a * std::log(y) - y - std::lgamma(a));
  constexpr int kIterations = 1000;
  constexpr double kPrecision = 1e-14;
  if (y < a + 1) {
    double term = 1 / a;
    double sum = term;
    for (int n = 1; n < kIterations && term > sum * kPrecision; ++n) {
      term *= y / (a + n);
      sum += term;
    }
    return 1 - scale * sum;
  }
  double b = y + 1 - a;
  double c = 1e300;
  double d = 1 / b;
  double fraction = d;
  for (int n = 1; n < kIterations; ++n) {
    const double numerator = -n * (n - a);
    b += 2;
    d = 1 / (numerator * d + b);
    c = b + numerator / c;
    const double change = c * d;
    fraction *= change;
    if (std::abs(change - 1) < kPrecision) break;
  }
  return scale * fraction;
}

double PValue(const std::vector<int>& counts,
              const std::vector<double>& expected) {
  assert(counts.size() == expected.size() && counts.size() >= 2);
  const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
  const double weight = std::accumulate(expected.begin(), expected.end(), 0.0);
  double chi_square = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double mean = expected[i] / weight * total;
    chi_square += (counts[i] - mean) * (counts[i] - mean) / mean;
  }
  return ChiSquareTail(chi_square, static_cast<int>(counts.size()) - 1);
}

double PValue(const std::vector<int>& counts, const std::vector<int>& others) {
  assert(counts.size() == others.size());
  const double n = std::accumulate(counts.begin(), counts.end(), 0.0);
  const double m = std::accumulate(others.begin(), others.end(), 0.0);
  double chi_square = 0;
  int categories = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double both = counts[i] + others[i];
    if (both == 0) continue;
    const double difference =
        counts[i] * std::sqrt(m / n) - others[i] * std::sqrt(n / m);
    chi_square += difference * difference / both;
    ++categories;
  }
  assert(categories >= 2);
  return ChiSquareTail(chi_square, categories - 1);
}

}  // namespace plsc::test
