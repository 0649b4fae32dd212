#pragma once

// The normal distribution's shares and quantiles, for tests and intervals.

namespace plsc {

/// The share of what is below z, to the last places also far out.
double NormalBelow(double z);

/// The z that has this share below it; infinite for 0 and 1.
double NormalQuantile(double share);

}  // namespace plsc
