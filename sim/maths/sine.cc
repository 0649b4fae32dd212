// x = n pi/2 + r with |r| <= pi/4 (Cody and Waite 1980, Software Manual for the
// Elementary Functions), and the sine of x is one of +-sin r, +-cos r by n
// mod 4. As x may come close to a multiple of pi/2, where r has few of its
// bits, r is a value and a rest (two.h).
//
// Up to 2^20: n has at most 20 bits, and pi/2 is the sum of P_0, P_1 and P_2 of
// 33 bits each, so that n P_i is exact, and of P_3, which is small against the
// rest; x - n P_0 is exact as well, both being within a factor of two or
// multiples of one small power of two. What is left out is n 2^-155, rounding n
// P_3 as much: 2^-135, against an r of at least 2^-60 (that of n = 29).
//
// Beyond: only x 2/pi mod 4 is of interest (Payne and Hanek 1983). x is an
// integer M times 2^(32 q), 2/pi is words w_i of 2^(-32 (i+1)), and of the
// products M_j w_i 2^(32 (j + q - 1 - i)) those of a whole word or more are
// multiples of 4. Six words' places are summed: one of quarter turns, five of
// their fraction, and what is below is less than 2^-125. No double is closer to
// a multiple of pi/2 than 2^-62 (Muller, Elementary Functions, 11.3).
//
// On |r| <= pi/4, z = r^2:  sin r = r + r z S(z),  cos r = 1 - z/2 + z^2 C(z),
// with S and C the interpolants in the Chebyshev nodes of [0, (pi/4)^2]
// (tests/sim/maths/coefficients.py): S is within 2.0e-17, which is 1.2e-17 of
// the sine, and C within 1.4e-18. A rest d of r changes them by d cos r and by
// -d sin r, of which 1 - z/2 and r are enough. Of the errors seen, up to 0.87
// units in the last place, most is the rounding of z/2 near pi/4.

#include "sim/maths/sine.h"

#include <cmath>
#include <cstdint>

#include <limits>

#include "sim/maths/bits.h"
#include "sim/maths/two.h"

namespace plsc {
namespace {

constexpr double kHalfPi[] = {0x1.921fb544p+0, 0x1.0b4611a6p-34,
                              0x1.3198a2ep-69, 0x1.b839a252049c1p-104};
constexpr double kTwoOverPi = 0x1.45f306dc9c883p-1;
constexpr Two kQuarterTurn = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr std::uint32_t kWords[] = {
    0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041,
    0xfe5163ab, 0xdebbc561, 0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c,
    0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484, 0xe99c7026, 0xb45f7e41,
    0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f,
    0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d,
    0x7527bac7, 0xebe5f17b, 0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08,
    0x56033046};
constexpr double kSine[] = {-0x1.5555555555555p-3,  0x1.1111111110bb2p-7,
                            -0x1.a01a019e83aaep-13, 0x1.71de37968a1p-19,
                            -0x1.ae600b02b6262p-26, 0x1.5e0b19f8b1451p-33};
constexpr double kCosine[] = {0x1.5555555555555p-5,  -0x1.6c16c16c16967p-10,
                              0x1.a01a019f4eb01p-16, -0x1.27e4fa17da09ep-22,
                              0x1.1eeb68e93b64cp-29, -0x1.907da367a37cbp-37};

/// Below, r is x itself.
constexpr double kEighth = 0.78;
/// Below, x is its own sine: x^2 / 6 is less than half a unit in the last
/// place.
constexpr double kTiny = 0x1p-27;
constexpr double kMostWithParts = 0x1p20;

struct Reduced {
  Two angle;          ///< r
  unsigned quarters;  ///< n mod 2^32
};

Reduced ReduceWithParts(double x) {
  const int n = static_cast<int>(x * kTwoOverPi + (x < 0 ? -0.5 : 0.5));
  const Two first = Sum(x - n * kHalfPi[0], -n * kHalfPi[1]);
  const Two second = Sum(first.value, -n * kHalfPi[2]);
  return {{second.value, first.rest + (second.rest - n * kHalfPi[3])},
          static_cast<unsigned>(n)};
}

/// Of a finite x >= 2^20.
Reduced ReduceWithWords(double x) {
  const auto bits = BitCast<std::uint64_t>(x);
  const int exponent = static_cast<int>(bits >> 52) - 1075;  // >= -32
  const std::uint64_t integer = (bits & 0xfffffffffffffU) | 1ULL << 52;
  const int q = (exponent + 32) / 32 - 1;  // rounded down
  // The integer shifted by what is left, in words.
  const int shift = exponent - 32 * q;
  const std::uint64_t low = (integer & 0xffffffffU) << shift;
  const std::uint64_t high = (low >> 32) + ((integer >> 32) << shift);
  const std::uint64_t m[] = {low & 0xffffffffU, high & 0xffffffffU, high >> 32};
  std::uint64_t sums[7] = {};  // of 2^(32 (p - 5)) quarter turns
  for (int p = 0; p < 6; ++p) {
    for (int j = 0; j < 3; ++j) {
      const int i = j + q + 4 - p;
      if (i < 0) continue;
      const std::uint64_t product = m[j] * kWords[i];
      sums[p] += product & 0xffffffffU;
      sums[p + 1] += product >> 32;
    }
    sums[p + 1] += sums[p] >> 32;
    sums[p] &= 0xffffffffU;
  }
  // The nearest whole number of quarter turns, and from it.
  const bool is_up = (sums[4] >> 31) != 0;
  const double first = static_cast<double>(sums[4]) * 0x1p-32 - (is_up ? 1 : 0);
  const Two second = Sum(first, static_cast<double>(sums[3]) * 0x1p-64);
  const Two third = Sum(second.value, static_cast<double>(sums[2]) * 0x1p-96);
  const double rest =
      second.rest + third.rest + static_cast<double>(sums[1]) * 0x1p-128;
  const Two angle = Product(third.value, kQuarterTurn.value);
  return {{angle.value, angle.rest + (third.value * kQuarterTurn.rest +
                                      rest * kQuarterTurn.value)},
          static_cast<unsigned>(sums[5]) + (is_up ? 1U : 0U)};
}

Reduced Reduce(double x) {
  const double size = std::fabs(x);
  if (size <= kEighth) return {{x, 0}, 0};
  if (size < kMostWithParts) return ReduceWithParts(x);
  if (!(size <= std::numeric_limits<double>::max()))
    return {{std::numeric_limits<double>::quiet_NaN(), 0}, 0};
  const Reduced reduced = ReduceWithWords(size);
  if (x > 0) return reduced;
  return {{-reduced.angle.value, -reduced.angle.rest}, 0U - reduced.quarters};
}

double SineNearZero(Two r) {
  // A sum of -0 and 0 would be 0.
  if (std::fabs(r.value) < kTiny)
    return r.rest == 0 ? r.value : r.value + r.rest;
  const double z = r.value * r.value;
  return r.value + (r.value * z * Polynomial(kSine, z) + r.rest * (1 - z / 2));
}

/// 1 - z/2 in two parts, as z/2 takes bits from 1.
double CosineNearZero(Two r) {
  const double z = r.value * r.value;
  const double half = z / 2;
  const double most = 1 - half;
  return most + (((1 - most) - half) +
                 (z * z * Polynomial(kCosine, z) - r.value * r.rest));
}

double Signed(double size, unsigned quarters) {
  return (quarters & 2U) != 0 ? -size : size;
}

double SineOf(const Reduced& x, unsigned quarters) {
  return Signed(
      (quarters & 1U) != 0 ? CosineNearZero(x.angle) : SineNearZero(x.angle),
      quarters);
}

}  // namespace

double Sin(double x) {
  const Reduced reduced = Reduce(x);
  return SineOf(reduced, reduced.quarters);
}

double Cos(double x) {
  const Reduced reduced = Reduce(x);
  return SineOf(reduced, reduced.quarters + 1);
}

SineCosine SinCos(double x) {
  if (std::fabs(x) <= kEighth)
    return {SineNearZero({x, 0}), CosineNearZero({x, 0})};
  const auto [angle, quarters] = Reduce(x);
  const double sine = SineNearZero(angle);
  const double cosine = CosineNearZero(angle);
  const bool is_odd = (quarters & 1U) != 0;
  return {Signed(is_odd ? cosine : sine, quarters),
          Signed(is_odd ? sine : cosine, quarters + 1)};
}

}  // namespace plsc
