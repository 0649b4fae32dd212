#include "sim/height_field.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "sim/lattice_noise.h"

namespace plsc {
namespace {

/// 0 to 1 with slope and curvature 0 at both ends: 6t^5 - 15t^4 + 10t^3.
double Blend(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

double BlendSlope(double t) {
  return 30 * t * t * (t * (t - 2) + 1);
}

// Of Blend, in the middle.
constexpr double kSteepestBlend = 1.875;

}  // namespace

HeightField::HeightField(const Rough& rough) : rough_(rough) {
  assert(rough.wavelength > 0);
  shift_ = Unshifted(0, 0).height;
}

double HeightField::steepest() const {
  // Neighbouring lattice points differ by twice the amplitude at most, along
  // each of the two axes.
  return std::numbers::sqrt2 * kSteepestBlend * 2 * rough_.amplitude /
         rough_.wavelength;
}

HeightField::Point HeightField::Unshifted(double x, double y) const {
  const double cell_x = std::floor(x / rough_.wavelength);
  const double cell_y = std::floor(y / rough_.wavelength);
  const double u = x / rough_.wavelength - cell_x;
  const double v = y / rough_.wavelength - cell_y;
  const auto i = static_cast<std::int64_t>(cell_x);
  const auto j = static_cast<std::int64_t>(cell_y);
  const auto corner = [&](int right, int up) {
    return 2 * LatticeNoise(rough_.seed, i + right, j + up, 0) - 1;
  };
  const double a = corner(0, 0), b = corner(1, 0);
  const double c = corner(0, 1), d = corner(1, 1);
  const double s = Blend(u), t = Blend(v);
  const double low = a + s * (b - a), high = c + s * (d - c);
  const double per_metre = rough_.amplitude / rough_.wavelength;
  return {rough_.amplitude * (low + t * (high - low)),
          per_metre * BlendSlope(u) * ((b - a) + t * ((d - c) - (b - a))),
          per_metre * BlendSlope(v) * (high - low)};
}

HeightField::Point HeightField::At(double x, double y) const {
  Point point = Unshifted(x, y);
  point.height -= shift_;
  return point;
}

}  // namespace plsc
