#pragma once

// Vargha and Delaney's A, the probability of superiority: how likely a value of
// the one sample is above one of the other, ties counted half. 0.5 is no
// difference; 0.56, 0.64 and 0.71 are where they call it small, medium, large.

#include <vector>

#include "runtime/report/interval.h"

namespace plsc {

class Rng;

struct Superiority {
  double a = 0.5;
  Interval interval;  ///< 95 %
};

/// Of two samples that have nothing to do with each other, each with one value
/// at least. A is W / (n m) of the rank-sum test.
Superiority SuperiorityOf(const std::vector<double>& x,
                          const std::vector<double>& y, Rng& rng);

/// Of pairs, the i-th of the one and of the other: in how many the first is
/// above. At least one.
Superiority PairedSuperiority(const std::vector<double>& x,
                              const std::vector<double>& y, Rng& rng);

}  // namespace plsc
