#pragma once

// Truth tables of clauses: one bit for each environment of a StateSpace, so
// that a table of 65,536 rows is a thousand machine words, and `and` and `or`
// take a thousand operations.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/genotype.h"
#include "compiler/state_space.h"

namespace plsc {

/// Whether the clause holds; `values` as in Environment. `and` binds tighter
/// than `or`; a clause without terms holds.
bool ClauseHolds(const Clause& clause, std::span<const double> values);

/// A set of environments. Operators want tables of one space.
class TruthTable {
 public:
  TruthTable(int size, bool value);

  int size() const { return size_; }
  bool operator[](int index) const {
    const auto i = static_cast<std::size_t>(index);
    return (words_[i / 64] >> (i % 64) & 1U) != 0;
  }
  int Count() const;
  /// The first environment in it; nothing when it is empty.
  std::optional<int> First() const;
  /// Adds environments [begin, end).
  void SetRange(std::size_t begin, std::size_t end);
  void Invert();
  /// A table of 64 becomes one of `size`: its word again and again.
  void Repeat(int size);

  TruthTable& operator&=(const TruthTable& other);
  TruthTable& operator|=(const TruthTable& other);

 private:
  void ClearUnused();

  int size_;
  std::vector<std::uint64_t> words_;  // bits beyond size_ are 0
};

/// In which environments of `space`, which knows all states of the clause, it
/// holds. The space has a size.
TruthTable Tabulate(const Clause& clause, const StateSpace& space);

/// In how many of how many environments a clause holds.
struct TruthCount {
  int holds = 0;
  int total = 0;
};

/// Nothing when the table would be too large.
std::optional<TruthCount> CountTruth(const Clause& clause,
                                     const std::vector<State>& states);

}  // namespace plsc
