// exp: x = k log 2 + r, |r| <= log(2)/2 (Cody and Waite 1980, chapter 6), and
// exp(x) = 2^k exp(r). log 2 is L_0 of 32 bits, so that k L_0 (11 bits of k)
// and x - k L_0 are exact, and L_1; what is left out is k 2^-86. With a rest d,
//   exp(r + d) = 1 + r + (r^2 E(r) + d),
// E the interpolant of (exp(r) - 1 - r)/r^2 in 11 Chebyshev nodes, within
// 1.4e-18 (of which d r, below 2^-55, is left out). 1 + r keeps its rest. 2^k
// is multiplied with in halves, as k goes beyond the exponents of a double;
// only the second product rounds, where the result is subnormal.
//
// log: x = 2^k m with m in [sqrt(1/2), sqrt(2)), f = m - 1 (exact). With
// s = f / (2 + f), m = (1 + s) / (1 - s) and
//   log m = 2 artanh s = 2 s + s R,  R = z L(z),  z = s^2,
// L the interpolant of (2 artanh(s) - 2 s)/(s z) in 7 Chebyshev nodes of
// [0, (3 - 2 sqrt 2)^2], within 3e-16, which counts z/2 = 1/68 at most.
// Rounding s would count twice; but as 2 s = f - s f and s f = h - s h, h =
// f^2/2,
//   log m = f - (h - s (h + R)),
// where what is rounded is small against f. k L_0 is exact again.

#include "sim/maths/exponential.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "sim/maths/bits.h"
#include "sim/maths/two.h"

namespace plsc {
namespace {

constexpr double kLn2[] = {0x1.62e42feep-1, 0x1.a39ef35793c76p-33};
constexpr double kOneOverLn2 = 0x1.71547652b82fep+0;
constexpr double kRootOfTwo = 0x1.6a09e667f3bcdp+0;
constexpr double kExponential[] = {0x1p-1,
                                   0x1.5555555555557p-3,
                                   0x1.5555555555556p-5,
                                   0x1.11111111100dfp-7,
                                   0x1.6c16c16c162d6p-10,
                                   0x1.a01a01abe62ddp-13,
                                   0x1.a01a01a6d7808p-16,
                                   0x1.71de02375656cp-19,
                                   0x1.27e4db67b4303p-22,
                                   0x1.af4ddd84882fep-26,
                                   0x1.1f72fc730b4ffp-29};
constexpr double kLogarithm[] = {0x1.5555555555558p-1, 0x1.99999999952e2p-2,
                                 0x1.2492492df148dp-2, 0x1.c71c62e5800a1p-3,
                                 0x1.7462b4ab2ef6bp-3, 0x1.39fe606542ddep-3,
                                 0x1.2b584aae78a57p-3};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// 2^k of a k that a normal number has.
double PowerOfTwo(int k) {
  return BitCast<double>(static_cast<std::uint64_t>(k + 1023) << 52);
}

}  // namespace

double Exp(double x) {
  if (std::isnan(x)) return std::numeric_limits<double>::quiet_NaN();
  if (x > 710) return kInfinity;  // above log(2^1024) = 709.78...
  if (x < -746) return 0;         // below log(2^-1075) = -745.13...
  const int k = static_cast<int>(x * kOneOverLn2 + (x < 0 ? -0.5 : 0.5));
  const Two r = Sum(x - k * kLn2[0], -k * kLn2[1]);
  const Two most = Sum(1, r.value);
  const double y =
      most.value +
      (most.rest +
       (r.value * r.value * Polynomial(kExponential, r.value) + r.rest));
  return y * PowerOfTwo(k / 2) * PowerOfTwo(k - k / 2);
}

double Log(double x) {
  if (!(x >= 0)) return std::numeric_limits<double>::quiet_NaN();
  if (x == 0) return -kInfinity;
  if (x == kInfinity) return x;
  int k = 0;
  if (x < std::numeric_limits<double>::min()) {
    x *= 0x1p54;
    k = -54;
  }
  const auto bits = BitCast<std::uint64_t>(x);
  k += static_cast<int>(bits >> 52) - 1023;
  double m = BitCast<double>((bits & 0xfffffffffffffU) | 1023ULL << 52);
  if (m >= kRootOfTwo) {
    m /= 2;
    ++k;
  }
  const double f = m - 1;
  const double s = f / (2 + f);
  const double z = s * s;
  const double h = f * f / 2;
  const double less =
      h - (s * (h + z * Polynomial(kLogarithm, z)) + k * kLn2[1]);
  return k * kLn2[0] - (less - f);
}

}  // namespace plsc
