#include "runtime/report/wilcoxon.h"

// R's mathematics without R.
#define MATHLIB_STANDALONE
#include <Rmath.h>

#include <algorithm>
#include <cmath>

namespace plsc {

namespace {

// R takes the distribution of W itself below this size of both samples.
constexpr std::size_t kExactBelow = 50;

struct Ranked {
  double w = 0;
  double ties = 0;  ///< sum of t^3 - t over groups of t equal values
};

/// The sum of ranks of x among both, equal values having the mean of theirs,
/// less the least that it can be.
Ranked Rank(const std::vector<double>& x, const std::vector<double>& y) {
  struct Value {
    double value;
    bool is_x;
  };
  std::vector<Value> all;
  all.reserve(x.size() + y.size());
  for (const double value : x) all.push_back({value, true});
  for (const double value : y) all.push_back({value, false});
  std::sort(all.begin(), all.end(),
            [](const Value& a, const Value& b) { return a.value < b.value; });
  const auto n = static_cast<double>(x.size());
  Ranked ranked{-n * (n + 1) / 2, 0};
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin;
    double of_x = 0;
    for (; end < all.size() && all[end].value == all[begin].value; ++end)
      of_x += all[end].is_x ? 1 : 0;
    const auto t = static_cast<double>(end - begin);
    const auto before = static_cast<double>(begin);
    ranked.w += of_x * (before + (t + 1) / 2);
    ranked.ties += t * t * t - t;
    begin = end;
  }
  return ranked;
}

double ExactP(double w, double m, double n) {
  // The tail that W is in, W itself included, twice.
  const double tail =
      w > m * n / 2 ? pwilcox(w - 1, m, n, 0, 0) : pwilcox(w, m, n, 1, 0);
  return std::min(2 * tail, 1.0);
}

std::optional<double> NormalP(const Ranked& ranked, double m, double n) {
  const double sum = m + n;
  const double sigma =
      std::sqrt(m * n / 12 * (sum + 1 - ranked.ties / (sum * (sum - 1))));
  if (!(sigma > 0)) return std::nullopt;
  const double difference = ranked.w - m * n / 2;
  const double continuity =
      difference > 0 ? 0.5 : (difference < 0 ? -0.5 : 0.0);
  const double z = (difference - continuity) / sigma;
  return std::min(1.0,
                  2 * std::min(pnorm(z, 0, 1, 1, 0), pnorm(z, 0, 1, 0, 0)));
}

}  // namespace

std::optional<RankSum> RankSumTest(const std::vector<double>& x,
                                   const std::vector<double>& y) {
  if (x.empty() || y.empty()) return std::nullopt;
  const Ranked ranked = Rank(x, y);
  const auto m = static_cast<double>(x.size());
  const auto n = static_cast<double>(y.size());
  RankSum test;
  test.w = ranked.w;
  test.is_exact =
      x.size() < kExactBelow && y.size() < kExactBelow && ranked.ties == 0;
  if (test.is_exact) {
    test.p = ExactP(ranked.w, m, n);
    return test;
  }
  const std::optional<double> p = NormalP(ranked, m, n);
  if (!p) return std::nullopt;
  test.p = *p;
  return test;
}

std::string_view Stars(double p) {
  if (p < 0.001) return "***";
  if (p < 0.01) return "**";
  return p < 0.05 ? "*" : "";
}

}  // namespace plsc
