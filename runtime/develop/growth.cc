// Rewriting without context does not care about order, so a string may be
// thrown away and the number of each symbol kept (its Parikh vector): a
// rewriting multiplies this vector by a matrix, what each symbol is rewritten
// into. The matrix is kept as lists of what is not 0. k rewritings cost k times
// the different symbols of the active productions, whatever the length of the
// string.
//
// Numbers saturate: 100 rewritings of a rule that doubles itself pass 2^64, and
// a sum that wraps around would call the longest strings short. The greatest
// number stands for itself and all beyond.

#include "runtime/develop/growth.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace plsc {

namespace {

constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();

std::uint64_t SaturatingAdd(std::uint64_t a, std::uint64_t b) {
  return a > kMost - b ? kMost : a + b;
}

std::uint64_t SaturatingMultiply(std::uint64_t a, std::uint64_t b) {
  return b != 0 && a > kMost / b ? kMost : a * b;
}

// What one symbol is rewritten into: how many of which.
using Tally = std::vector<std::pair<std::size_t, std::uint64_t>>;

std::vector<Tally> TalliesOf(const ActiveRules& active) {
  std::vector<Tally> tallies(active.joined.size());
  std::vector<std::uint64_t> counts(active.joined.size(), 0);
  for (std::size_t head = 0; head < tallies.size(); ++head) {
    const auto joined = active.joined[static_cast<SymbolId>(head)];
    for (const Occurrence& occurrence : joined)
      ++counts[static_cast<std::size_t>(occurrence.symbol)];
    for (const Occurrence& occurrence : joined) {
      const auto symbol = static_cast<std::size_t>(occurrence.symbol);
      if (counts[symbol] == 0) continue;  // already told
      tallies[head].emplace_back(symbol, counts[symbol]);
      counts[symbol] = 0;
    }
  }
  return tallies;
}

}  // namespace

std::uint64_t DerivedLength(const Genotype& genotype,
                            const ActiveRules& active) {
  const std::vector<Tally> tallies = TalliesOf(active);
  std::vector<std::uint64_t> counts(tallies.size(), 0);
  counts[static_cast<std::size_t>(genotype.axiom)] = 1;
  for (int i = 0; i < genotype.development.iterations; ++i) {
    std::vector<std::uint64_t> next(counts.size(), 0);
    for (std::size_t symbol = 0; symbol < counts.size(); ++symbol) {
      if (counts[symbol] == 0) continue;
      // Without active rules a symbol stays.
      if (tallies[symbol].empty())
        next[symbol] = SaturatingAdd(next[symbol], counts[symbol]);
      for (const auto& [successor, times] : tallies[symbol])
        next[successor] = SaturatingAdd(
            next[successor], SaturatingMultiply(counts[symbol], times));
    }
    counts.swap(next);
  }
  std::uint64_t length = 0;
  for (const std::uint64_t count : counts)
    length = SaturatingAdd(length, count);
  return length;
}

std::vector<std::uint64_t> ReadingLengths(const Genotype& genotype,
                                          const ActiveRules& active) {
  const std::span<const Occurrence> production = active.joined[genotype.axiom];
  if (production.empty()) return {};
  const auto sum = [](const std::vector<std::uint64_t>& lengths,
                      std::span<const Occurrence> string) {
    std::uint64_t length = 0;
    for (const Occurrence& one : string)
      length =
          SaturatingAdd(length, lengths[static_cast<std::size_t>(one.symbol)]);
    return length;
  };
  // Of what each symbol has become.
  std::vector<std::uint64_t> lengths(active.joined.size(), 1);
  std::vector<std::uint64_t> readings;
  for (int i = 0; i < genotype.development.iterations; ++i) {
    readings.push_back(sum(lengths, production.subspan(1)));
    std::vector<std::uint64_t> next = lengths;
    for (std::size_t symbol = 0; symbol < next.size(); ++symbol)
      if (const auto joined = active.joined[static_cast<SymbolId>(symbol)];
          !joined.empty())
        next[symbol] = sum(lengths, joined);
    lengths = std::move(next);
  }
  return readings;
}

std::optional<Multiplier> GreatestMultiplier(const ActiveRules& active) {
  Multiplier greatest;
  for (std::size_t head = 0; head < active.joined.size(); ++head) {
    const auto symbol = static_cast<SymbolId>(head);
    const std::span<const Occurrence> joined = active.joined[symbol];
    const auto copies = static_cast<std::uint64_t>(
        std::count_if(joined.begin(), joined.end(),
                      [&](const Occurrence& o) { return o.symbol == symbol; }));
    if (copies > greatest.copies) greatest = {symbol, copies, joined.size()};
  }
  if (greatest.copies < 2) return std::nullopt;
  return greatest;
}

}  // namespace plsc
