#pragma once

// The environments that clauses can tell apart. There are finitely many: the
// values of bool and enum states that a term names, and for real states the
// thresholds and the intervals between them. Values that no term tells apart
// are one class, so enumerating classes decides what holds everywhere.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/genotype.h"

namespace plsc {

/// Values of one state that no clause tells apart.
struct ValueClass {
  double value = 0;        ///< one of them
  std::vector<int> named;  ///< kBool, kEnum: all of them
  double low = 0;          ///< kReal: from here
  double high = 0;         ///< kReal: to here
  bool has_low = true;     ///< kReal: whether `low` itself belongs
  bool has_high = true;
};

/// As a condition of the state: `inclined = True`, `ground = dry|wet`,
/// `temperature >= 5 and temperature < 30.5`. Empty when it is every value.
std::string DescribeClass(const ValueClass& values, const State& state);
/// Only the values: `True`, `dry|wet`, `5..<30.5`.
std::string ClassLabel(const ValueClass& values, const State& state);

/// Of the rules, in their order.
std::vector<const Clause*> ClausesOf(const Genotype& genotype);
/// Of the rules of two genotypes that have the same states.
std::vector<const Clause*> ClausesOf(const Genotype& one,
                                     const Genotype& other);

class StateSpace {
 public:
  StateSpace(std::span<const Clause* const> clauses,
             const std::vector<State>& states);
  /// Of all rules of a genotype.
  explicit StateSpace(const Genotype& genotype);

  /// How many environments, or nothing if beyond kMaxCombinations.
  std::optional<int> size() const { return size_; }
  /// The states that the clauses ask about, in declaration order. The last
  /// varies fastest, as in a written truth table.
  const std::vector<StateId>& states() const { return ids_; }
  /// By position in states().
  const std::vector<ValueClass>& classes(std::size_t position) const {
    return classes_[position];
  }
  /// Which class of state `position` environment `index` is in.
  std::size_t ClassAt(int index, std::size_t position) const {
    return static_cast<std::size_t>(index) / strides_[position] %
           classes_[position].size();
  }
  /// How many environments pass before state `position` changes.
  std::size_t stride(std::size_t position) const { return strides_[position]; }
  /// A member of environment number `index`; states that no clause asks about
  /// have their first value.
  std::vector<double> At(int index) const;
  /// `inclined = True and hot = False`; "always" when nothing is asked.
  std::string Describe(int index, const std::vector<State>& states) const;

  /// Sixteen states of two values: the most that a genotype of the paper's
  /// kind could ask for, and a table of 65,536 rows is made in milliseconds.
  static constexpr int kMaxCombinations = 1 << 16;

 private:
  std::vector<StateId> ids_;
  std::vector<std::vector<ValueClass>> classes_;  // by position in ids_
  std::vector<std::size_t> strides_;              // by position in ids_
  std::vector<double> first_;                     // value of each state
  std::optional<int> size_;
};

}  // namespace plsc
