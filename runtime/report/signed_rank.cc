// Idea: if the values lie around 0, each sign is a toss of a coin, so all 2^n
// ways to give ranks their signs are equally likely; how many of them come to
// each sum is counted by adding one rank after the other. Ranks of ties are
// halves, so sums are counted doubled. Shares and not counts are added up, so
// that nothing overflows. Cost: n^3 additions, below a hundredth of a second
// for 100 values. Source: Wilcoxon 1945, "Individual comparisons by ranking
// methods".

#include "runtime/report/signed_rank.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plsc {

namespace {

/// From 1, doubled; sizes that are equal have the mean of theirs.
std::vector<std::size_t> DoubledRanks(const std::vector<double>& sizes) {
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return sizes[a] < sizes[b]; });
  std::vector<std::size_t> ranks(sizes.size());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && sizes[order[end]] == sizes[order[begin]])
      ++end;
    for (std::size_t i = begin; i < end; ++i) ranks[order[i]] = begin + 1 + end;
    begin = end;
  }
  return ranks;
}

/// Of each sum of some of the ranks: its share of all ways.
std::vector<double> SharesOf(const std::vector<std::size_t>& ranks) {
  std::vector<double> shares = {1};
  for (const std::size_t rank : ranks) {
    std::vector<double> next(shares.size() + rank);
    for (std::size_t sum = 0; sum < shares.size(); ++sum) {
      next[sum] += shares[sum] / 2;
      next[sum + rank] += shares[sum] / 2;
    }
    shares = std::move(next);
  }
  return shares;
}

}  // namespace

std::optional<SignedRank> SignedRankTest(const std::vector<double>& values) {
  std::vector<double> sizes;
  std::vector<bool> is_above;
  for (const double value : values) {
    if (value == 0) continue;
    sizes.push_back(std::abs(value));
    is_above.push_back(value > 0);
  }
  if (sizes.empty()) return std::nullopt;
  const std::vector<std::size_t> ranks = DoubledRanks(sizes);
  std::size_t sum = 0;
  for (std::size_t i = 0; i < ranks.size(); ++i)
    if (is_above[i]) sum += ranks[i];
  const std::vector<double> shares = SharesOf(ranks);
  const auto at = shares.begin() + static_cast<std::ptrdiff_t>(sum);
  const double below = std::accumulate(shares.begin(), at + 1, 0.0);
  const double above = std::accumulate(at, shares.end(), 0.0);
  return SignedRank{static_cast<double>(sum) / 2,
                    std::min(1.0, 2 * std::min(below, above))};
}

}  // namespace plsc
