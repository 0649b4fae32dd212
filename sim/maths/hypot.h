#pragma once

// sqrt(a^2 + b^2) of the same bits on every machine.

namespace plsc {

/// Infinite where a or b is, also if the other is no number; where the root
/// itself is beyond all numbers; but not where only the squares would be.
double Hypot(double a, double b);

}  // namespace plsc
