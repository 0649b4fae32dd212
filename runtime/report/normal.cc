#include "runtime/report/normal.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace plsc {

// Far out a rounded quotient would cost z^2 units of the last place, so there
// are more places.
double NormalBelow(double z) {
  return static_cast<double>(
      std::erfc(-z / std::numbers::sqrt2_v<long double>) / 2);
}

// By halving: a few calls an interval are no reason for a formula of its own.
double NormalQuantile(double share) {
  constexpr double kFar = 40;  // beyond it nothing is left in a double
  constexpr int kHalvings = 60;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (share <= 0) return -kInfinity;
  if (share >= 1) return kInfinity;
  double low = -kFar;
  double high = kFar;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (NormalBelow(middle) < share ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace plsc
