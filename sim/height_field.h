#pragma once

// Rough ground as a height over the plane: value noise. Lattice points
// `wavelength` apart have random heights from -amplitude to +amplitude, and
// between them a polynomial blends, so that height and slope have no jumps.
// No libm in it: the same bits on every machine. Shifted so that the ground
// passes through the origin.

#include "sim/terrain.h"

namespace plsc {

class HeightField {
 public:
  explicit HeightField(const Rough& rough);

  struct Point {
    double height = 0;   ///< m
    double slope_x = 0;  ///< of the height along x
    double slope_y = 0;
  };
  Point At(double x, double y) const;

  /// No point is higher, and none lower than its negative, m.
  double bound() const { return 2 * rough_.amplitude; }
  /// No slope in any direction is steeper.
  double steepest() const;

 private:
  Point Unshifted(double x, double y) const;

  Rough rough_;
  double shift_ = 0;
};

}  // namespace plsc
