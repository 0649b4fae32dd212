#pragma once

// Wilcoxon's signed-rank test of whether values lie around 0: two-sided and
// exact, whatever ties there are (R's wilcox.test(x) has the same p where no
// two have the same size and none is 0; else it is an approximation there).

#include <optional>
#include <vector>

namespace plsc {

struct SignedRank {
  double v = 0;  ///< R's V: sum of the ranks of those above 0
  double p = 1;  ///< two-sided
};

/// Zeros say nothing and are left out, as R does; nothing if there is no other.
std::optional<SignedRank> SignedRankTest(const std::vector<double>& values);

}  // namespace plsc
