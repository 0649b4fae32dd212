#pragma once

// The IR: what is inherited, varied and developed. Plain data, numbered, free
// of source positions; Print writes it as text that compiles back to an equal
// Genotype, and Verify holds its invariants.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/alphabet.h"

namespace plsc {

/// Index into Genotype::states.
enum class StateId : std::uint16_t {};

enum class StateType : std::uint8_t { kBool, kReal, kEnum };

/// Something that the robot can sense of its environment, and that clauses
/// may ask about (the paper's environmental state, such as `inclined`).
struct State {
  std::string name;
  StateType type = StateType::kBool;
  double low = 0;                   ///< kReal only, inclusive
  double high = 0;                  ///< kReal only, inclusive
  std::vector<std::string> values;  ///< kEnum only, at least two, unique

  friend bool operator==(const State&, const State&) = default;
};

inline const State& StateAt(const std::vector<State>& states, StateId id) {
  return states[static_cast<std::size_t>(id)];
}

/// What a robot senses: one value a state, indexed by StateId. A bool is 0 or
/// 1, an enum the index into State::values, a real the number itself.
struct Environment {
  std::vector<double> values;

  friend bool operator==(const Environment&, const Environment&) = default;
};

/// Bool and enum states are compared with = and != only.
enum class Comparison : std::uint8_t {
  kEqual,
  kNotEqual,
  kLess,
  kLessEqual,
  kGreater,
  kGreaterEqual,
};

/// `inclined = True`, `temperature > 30.5`. `value` as in Environment.
struct Term {
  StateId state{};
  Comparison comparison = Comparison::kEqual;
  double value = 0;

  friend bool operator==(const Term& a, const Term& b);  // bit for bit
};

enum class Connective : std::uint8_t { kAnd, kOr };

/// A regulation clause: terms joined from left to right, `and` binding tighter
/// than `or`. A flat list, because evolution flips its parts one by one.
/// Without terms it always holds (the Baseline encoding).
struct Clause {
  std::vector<Term> terms;
  std::vector<Connective> connectives;  ///< one less than terms, or empty

  bool is_always() const { return terms.empty(); }
  friend bool operator==(const Clause&, const Clause&) = default;
};

/// A symbol of a production with its arguments, in the order of
/// SymbolInfo::parameters; unused places are +0.
struct Symbol {
  SymbolId id{};
  std::array<double, kMaxParameters> arguments{};

  friend bool operator==(const Symbol& a, const Symbol& b);  // bit for bit
};

/// The paper's regulatory tuple (c, p): while the clause holds, `head` may be
/// rewritten into `production`.
struct Rule {
  SymbolId head{};
  Clause clause;
  std::vector<Symbol> production;  ///< never empty

  friend bool operator==(const Rule&, const Rule&) = default;
};

/// How the genotype develops; the paper's values are the defaults (Table 2
/// and "Mapping stage 2").
struct DevelopmentSettings {
  int iterations = 3;        ///< k, rewritings, 0 to 100
  int max_modules = 15;      ///< m, the core counted, sensors not; 1 to 1000
  bool move_to_new = false;  ///< after mounting, the module-reference follows

  friend bool operator==(const DevelopmentSettings&,
                         const DevelopmentSettings&) = default;
};

/// One regulated L-system. Copies are independent.
struct Genotype {
  std::string name;
  AlphabetPtr alphabet = PlasticodingAlphabet();
  std::vector<State> states;
  SymbolId axiom{};
  DevelopmentSettings development;
  std::optional<int> max_terms;  ///< u; absent: any number a clause
  std::optional<int> max_rules;  ///< l; absent: any number a symbol
  /// Grouped by head in alphabet order; within a head in the order in which
  /// active productions are joined.
  std::vector<Rule> rules;

  const State& StateOf(StateId id) const { return StateAt(states, id); }
  const SymbolInfo& SymbolOf(SymbolId id) const { return (*alphabet)[id]; }

  /// Equal alphabets (by value) and equal everything else, bit for bit.
  friend bool operator==(const Genotype& a, const Genotype& b);
};

}  // namespace plsc
