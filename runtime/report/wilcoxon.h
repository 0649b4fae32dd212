#pragma once

// The two-sided Wilcoxon rank-sum test (Mann-Whitney), as R's wilcox.test(x, y)
// has it: the paper's test between encodings. Ways are counted exactly, so p is
// R's to 14 digits and not to the last bit (docs/decisions/0017).

#include <optional>
#include <string_view>
#include <vector>

namespace plsc {

struct RankSum {
  double w = 0;  ///< R's W: pairs in which x is greater, ties counted half
  double p = 1;  ///< two-sided
  /// From the distribution of W itself; otherwise from the normal one, with
  /// corrections for ties and for continuity.
  bool is_exact = false;
};

/// Exact if both samples have fewer than 50 values and no two values are
/// equal, as R decides. Nothing for an empty sample, or when all values are
/// equal (R's p is no number then). Values are numbers.
std::optional<RankSum> RankSumTest(const std::vector<double>& x,
                                   const std::vector<double>& y);

/// "***" below 0.001, "**" below 0.01, "*" below 0.05, else "" (the paper's
/// figures).
std::string_view Stars(double p);

}  // namespace plsc
