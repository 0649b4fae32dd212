#pragma once

// The sine of sim/maths as C99 text, operation by operation and constant by
// constant, for exported controllers: no C library's own is the same
// everywhere.

namespace plsc {

inline constexpr const char* kSineInC = R"(
/* The sine of an x of at most 2^20 rad, as plsc has it: of r, after n quarter
 * turns, or the cosine; r with the rest that it has no bits for. */
static inline double @_sine(double x) {
  static const double quarter[] = {
      0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2ep-69, 0x1.b839a252049c1p-104};
  static const double s[] = {
      -0x1.5555555555555p-3, 0x1.1111111110bb2p-7, -0x1.a01a019e83aaep-13,
      0x1.71de37968a1p-19, -0x1.ae600b02b6262p-26, 0x1.5e0b19f8b1451p-33};
  static const double c[] = {
      0x1.5555555555555p-5, -0x1.6c16c16c16967p-10, 0x1.a01a019f4eb01p-16,
      -0x1.27e4fa17da09ep-22, 0x1.1eeb68e93b64cp-29, -0x1.907da367a37cbp-37};
  int n = 0, i;
  double r = x, rest = 0.0, z, sum = 0.0, size;
  if (fabs(x) > 0.78) {
    double first, second, moved;
    n = (int)(x * 0x1.45f306dc9c883p-1 + (x < 0.0 ? -0.5 : 0.5));
    first = x - n * quarter[0];
    second = -n * quarter[1];
    r = first + second;
    moved = r - first;
    rest = (first - (r - moved)) + (second - moved);
    first = r;
    second = -n * quarter[2];
    r = first + second;
    moved = r - first;
    rest += ((first - (r - moved)) + (second - moved)) - n * quarter[3];
  }
  z = r * r;
  if (n % 2 == 0) {
    for (i = 5; i >= 0; --i) sum = sum * z + s[i];
    size = r + (r * z * sum + rest * (1.0 - z / 2.0));
    if (fabs(r) < 0x1p-27) size = rest == 0.0 ? r : r + rest;
  } else {
    const double half = z / 2.0, most = 1.0 - half;
    for (i = 5; i >= 0; --i) sum = sum * z + c[i];
    size = most + (((1.0 - most) - half) + (z * z * sum - r * rest));
  }
  return (n & 2) != 0 ? -size : size;
}
)";

}  // namespace plsc
