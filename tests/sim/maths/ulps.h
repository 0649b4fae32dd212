#pragma once

// How far functions are from those of more bits, in units in the last place.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace plsc::test {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The distance of `got` in the units of a double near `want`.
inline double Ulps(double got, long double want) {
  if (static_cast<long double>(got) == want) return 0;
  const double near = std::fabs(static_cast<double>(want));
  if (!std::isfinite(near)) return near == std::fabs(got) ? 0 : kInfinity;
  int exponent = 0;
  std::frexp(std::max(near, std::numeric_limits<double>::min()), &exponent);
  const long double unit = std::ldexp(1.0L, exponent - 53);
  const auto ulps = static_cast<double>(std::fabs(got - want) / unit);
  return std::isnan(ulps) ? kInfinity : ulps;
}

/// The worst of many.
class Worst {
 public:
  void Add(double got, long double want, double argument) {
    const double ulps = Ulps(got, want);
    if (ulps <= most) return;
    most = ulps;
    at = argument;
  }
  double most = 0;
  double at = 0;
};

inline bool IsSame(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Numbers of a fixed seed, without the standard library's distributions, which
/// are not the same everywhere (splitmix64, Steele and others 2014).
class Arguments {
 public:
  explicit Arguments(std::uint64_t seed) : state_(seed) {}

  std::uint64_t Bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  double Between(double low, double high) {
    return low + (high - low) * (static_cast<double>(Bits() >> 11) * 0x1p-53);
  }
  /// Of any sign, with exponents of two in [low, high].
  double OfExponent(int low, int high) {
    const std::uint64_t bits = Bits();
    const auto exponent = static_cast<std::uint64_t>(low + 1023) +
                          Bits() % static_cast<std::uint64_t>(high - low + 1);
    return std::bit_cast<double>((bits & 0x800fffffffffffffU) | exponent << 52);
  }

 private:
  std::uint64_t state_;
};

}  // namespace plsc::test
