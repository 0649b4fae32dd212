#pragma once

// Arc tangent and arc cosine, of the same bits on every machine; within 0.7
// units in the last place. Zeros, infinities and what is no number as C's
// functions have them.

namespace plsc {

/// rad in [-pi, pi]: of the point (x, y), from the x axis towards y.
double Atan2(double y, double x);

/// rad in [0, pi]; not a number where |x| > 1.
double Acos(double x);

}  // namespace plsc
