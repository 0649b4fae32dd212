#pragma once

// Truth tables of clauses. A clause can tell apart only finitely many
// environments: the values of bool and enum states, and for real states the
// thresholds that it names and what lies between them. Enumerating these
// decides what holds in every environment.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/genotype.h"

namespace plsc {

/// Whether the clause holds; `values` as in Environment. `and` binds tighter
/// than `or`; a clause without terms holds.
bool ClauseHolds(const Clause& clause, std::span<const double> values);

/// The environments that a list of clauses can tell apart.
class StateSpace {
 public:
  StateSpace(std::span<const Clause* const> clauses,
             const std::vector<State>& states);

  /// How many, or nothing if beyond kMaxCombinations.
  std::optional<int> size() const { return size_; }
  /// The states that the clauses ask about, in declaration order.
  const std::vector<StateId>& states() const { return ids_; }
  /// Number `index` of them; states that no clause asks about are 0.
  std::vector<double> At(int index) const;

  /// Some ten states of two values; a table that anybody would still look at
  /// is far smaller.
  static constexpr int kMaxCombinations = 4096;

 private:
  std::vector<StateId> ids_;
  std::vector<std::vector<double>> samples_;  // by position in ids_
  std::size_t state_count_ = 0;
  std::optional<int> size_;
};

/// In how many of how many environments a clause holds.
struct TruthCount {
  int holds = 0;
  int total = 0;
};

/// Nothing when the table would be too large.
std::optional<TruthCount> CountTruth(const Clause& clause,
                                     const std::vector<State>& states);

}  // namespace plsc
