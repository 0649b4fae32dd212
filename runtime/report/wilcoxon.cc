#include "runtime/report/wilcoxon.h"

// The exact test asks how many of the equally likely ways to choose which
// values are x's have a W at least as far from its middle. Mann and Whitney
// ("On a Test of Whether one of Two Random Variables is Stochastically Larger
// than the Other", 1947) count them by a recurrence over the sizes of samples:
// the greatest value is an x, which is then greater than all n of y, or a y:
//   ways(m, n, w) = ways(m - 1, n, w - n) + ways(m, n - 1, w)
// What solves it is Gauss's binomial coefficient: ways(m, n, w) is the
// coefficient of q^w in the product over i = 1 .. m of
//   (1 - q^(n + i)) / (1 - q^i)
// Multiplying and dividing by 1 - q^k each run through the coefficients once,
// in place: at most 2 m (w + 1) additions of integers, so the count is exact.
// The first i factors together count the ways of i and n, so what goes below
// zero between a multiplication and its division comes back (unsigned numbers
// wrap).

#include <algorithm>
#include <cmath>
#include <numeric>

#include "runtime/report/normal.h"

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

// All ways together are at most 98! / 49!^2 < 2^95 (kExactBelow), so no sum of
// ways overflows; doubles would begin to round at 30 values of each.
__extension__ using Ways = unsigned __int128;

/// To choose which m of m + n values are x's.
Ways AllWays(std::size_t m, std::size_t n) {
  Ways ways = 1;
  for (std::size_t i = 1; i <= m; ++i) ways = ways * (n + i) / i;
  return ways;
}

/// Those of them whose W is `most` or less.
Ways WaysUpTo(std::size_t most, std::size_t m, std::size_t n) {
  std::vector<Ways> ways(most + 1);  // of each W
  ways[0] = 1;
  for (std::size_t i = 1; i <= m; ++i) {
    for (std::size_t w = most; w >= n + i; --w) ways[w] -= ways[w - (n + i)];
    for (std::size_t w = i; w <= most; ++w) ways[w] += ways[w - i];
  }
  return std::accumulate(ways.begin(), ways.end(), Ways{0});
}

double ExactP(std::size_t w, std::size_t m, std::size_t n) {
  // The tail that W is in, W itself included, twice; the other way round as
  // many ways lead to m n - W as to W.
  const std::size_t tail = std::min(w, m * n - w);
  return std::min(2 * static_cast<double>(WaysUpTo(tail, m, n)) /
                      static_cast<double>(AllWays(m, n)),
                  1.0);
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
  return 2 * NormalBelow(-std::abs(z));
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
    test.p = ExactP(static_cast<std::size_t>(ranked.w), x.size(), y.size());
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
