// Both are the angle of a point (d, n) with 0 <= n <= d, mirrored: what is
// asked for is e pi/4 + s a with a = atan(n / d) <= pi/4, e in {0, 2, 4} and s
// = +-1. Where a > pi/8, atan(n/d) = pi/4 - atan((d - n) / (d + n)) makes it
// once more of this form, with e + s and -s, and the argument at most tan(pi/8)
// = sqrt(2) - 1 (Cody and Waite 1980, chapter 11, has the idea with pi/6).
//
// The quotient u is a value and a rest (two.h), so that its rounding does not
// count: d atan(u) = rest / (1 + u^2). With z = u^2
//   atan(u + rest) = u - (u z A(z) - rest / (1 + z)),
// A the interpolant of (1 - atan(u)/u)/z in 12 Chebyshev nodes of
// [0, (sqrt(2) - 1)^2] (tests/sim/maths/coefficients.py), within 1e-18.
//
// acos(x) = 2 atan(sqrt((1 - x) / (1 + x))), as tan^2(t/2) = (1 - cos t) /
// (1 + cos t); 1 - x and 1 + x, their roots and their quotient keep their
// rests.

#include "sim/maths/arc.h"

#include <cmath>
#include <limits>

#include "sim/maths/two.h"

namespace plsc {
namespace {

constexpr Two kEighthTurns[] = {{0, 0},
                                {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
                                {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54},
                                {0x1.2d97c7f3321d2p+1, 0x1.a79394c9e8a0ap-54},
                                {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53}};
constexpr double kTanOfSixteenth = 0x1.a827999fcef32p-2;
constexpr double kArc[] = {
    0x1.5555555555555p-2,  -0x1.9999999999953p-3, 0x1.249249248d7eep-3,
    -0x1.c71c71c304b68p-4, 0x1.745d165df3f95p-4,  -0x1.3b1392d9e785cp-4,
    0x1.110e880a7a521p-4,  -0x1.e19a13b9fc6dfp-5, 0x1.ac7a938b69c93p-5,
    -0x1.74ddd408bb4c1p-5, 0x1.1b33b923aa954p-5,  -0x1.0ad36a455cafbp-6};
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// eighths pi/4 + direction atan(u).
double Turned(int eighths, double direction, Two u) {
  const double z = u.value * u.value;
  const double less = u.value * z * Polynomial(kArc, z) - u.rest / (1 + z);
  const Two base = kEighthTurns[eighths];
  const Two most = Sum(base.value, direction * u.value);
  return most.value + (most.rest + (base.rest - direction * less));
}

/// eighths pi/4 + direction atan(n / d), 0 <= n <= d.
double Angle(int eighths, double direction, Two n, Two d) {
  if (n.value <= kTanOfSixteenth * d.value)
    return Turned(eighths, direction, Quotient(n, d));
  Two less = Sum(d.value, -n.value);
  Two more = Sum(d.value, n.value);
  less.rest += d.rest - n.rest;
  more.rest += d.rest + n.rest;
  return Turned(eighths + static_cast<int>(direction), -direction,
                Quotient(less, more));
}

/// The point (d, n) by a power of two where two.h could not multiply with d.
double ScaleOf(double d) {
  if (d > 0x1p500) return 0x1p-600;
  return d < 0x1p-500 ? 0x1p600 : 1;
}

}  // namespace

double Atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNaN;
  const bool is_left = std::signbit(x);
  const bool is_steep = std::fabs(y) > std::fabs(x);
  const int eighths = is_steep ? 2 : is_left ? 4 : 0;
  const double direction = is_steep == is_left ? 1 : -1;
  double n = is_steep ? std::fabs(x) : std::fabs(y);
  double d = is_steep ? std::fabs(y) : std::fabs(x);
  if (std::isinf(d)) {
    n = std::isinf(n) ? 1 : 0;
    d = 1;
  } else if (d == 0) {
    d = 1;
  }
  // Below 2^-30 the quotient is its own arc, and rounding it is all there is;
  // so n / d may be as small as it likes, and n above can be multiplied with.
  if (n / d < 0x1p-30)
    return std::copysign(Turned(eighths, direction, {n / d, 0}), y);
  const double scale = ScaleOf(d);
  return std::copysign(
      Angle(eighths, direction, {n * scale, 0}, {d * scale, 0}), y);
}

double Acos(double x) {
  if (!(std::fabs(x) <= 1)) return kNaN;
  const Two less = Root(Sum(1, -x));
  const Two more = Root(Sum(1, x));
  return 2 * (x < 0 ? Angle(2, -1, more, less) : Angle(0, 1, less, more));
}

}  // namespace plsc
