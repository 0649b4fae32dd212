#pragma once

// Sums, products, quotients and roots of doubles with what their rounding
// leaves out, each of a few plain operations.
//
// A Two is the unevaluated sum of a double and of what is missing from it, at
// most about a unit in its last place. Sum and Product are exact (Knuth 1969;
// Dekker 1971, A floating-point technique for extending the available
// precision); Quotient and Root are Newton's steps from the rounded result,
// with the residual of it, and are right to about 2^-100. All of it holds in
// round-to-nearest without contraction into fused operations, if nothing
// overflows, and no factor exceeds 2^990 or product falls below 2^-960.

#include <cmath>
#include <cstddef>

namespace plsc {

struct Two {
  double value = 0;
  double rest = 0;
};

/// a + b, exactly.
constexpr Two Sum(double a, double b) {
  const double sum = a + b;
  const double of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// a b, exactly: each factor in halves of 26 bits, the products of which fit.
constexpr Two Product(double a, double b) {
  constexpr double kSplit = 0x1p27 + 1;
  const double a_high = a * kSplit - (a * kSplit - a);
  const double b_high = b * kSplit - (b * kSplit - b);
  const double a_low = a - a_high;
  const double b_low = b - b_high;
  const double product = a * b;
  return {product,
          ((a_high * b_high - product) + a_high * b_low + a_low * b_high) +
              a_low * b_low};
}

/// n / d: q + (n - q d) / d.
constexpr Two Quotient(Two n, Two d) {
  const double quotient = n.value / d.value;
  const Two back = Product(quotient, d.value);
  return {quotient,
          ((n.value - back.value) - back.rest + n.rest - quotient * d.rest) /
              d.value};
}

/// The square root of h >= 0: r + (h - r^2) / (2 r).
inline Two Root(Two h) {
  if (h.value == 0) return {};
  const double root = std::sqrt(h.value);
  const Two back = Product(root, root);
  return {root, ((h.value - back.value) - back.rest + h.rest) / (2 * root)};
}

/// c_0 + c_1 x + ... by Horner's rule.
template <std::size_t N>
constexpr double Polynomial(const double (&c)[N], double x) {
  double sum = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) sum = sum * x + c[i];
  return sum;
}

}  // namespace plsc
