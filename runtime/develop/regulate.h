#pragma once

// Environmental regulation: which rules of a genotype are active in an
// environment, and what each symbol is therefore rewritten into. The first
// stage of development (paper, "Environmental regulation").

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/genotype.h"

namespace plsc {

/// Index into Genotype::rules.
using RuleIndex = std::uint16_t;
/// The rule of a symbol that no rule made: the axiom.
inline constexpr RuleIndex kNoRule = 0xFFFF;

/// One symbol of a string, and where in the genotype it was written: symbol
/// `position` of the production of `rule`. Eight bytes; the arguments stay in
/// the genotype.
struct Occurrence {
  SymbolId symbol{};
  RuleIndex rule = kNoRule;
  std::uint32_t position = 0;

  friend bool operator==(const Occurrence&, const Occurrence&) = default;
};

using Arguments = std::array<double, kMaxParameters>;

/// As it is written at that place; the axiom has no arguments.
inline const Arguments& ArgumentsOf(const Genotype& genotype,
                                    const Occurrence& occurrence) {
  static constexpr Arguments kNone{};
  return occurrence.rule == kNoRule ? kNone
                                    : genotype.rules[occurrence.rule]
                                          .production[occurrence.position]
                                          .arguments;
}
inline Symbol SymbolAt(const Genotype& genotype, const Occurrence& occurrence) {
  return {occurrence.symbol, ArgumentsOf(genotype, occurrence)};
}

/// What each symbol is rewritten into, by SymbolId: the productions of its
/// active rules joined in order; of C, the leading C of the second and later
/// ones is left out. Empty: no rule is active, the symbol stays as it is.
/// All successors lie in one array, because a vector a symbol would be most of
/// the allocations of a development.
class Successors {
 public:
  Successors() = default;  ///< of no symbols
  /// `begins`: by symbol, where its successor begins in `occurrences`; one more
  /// for the end of the last.
  Successors(std::vector<Occurrence> occurrences,
             std::vector<std::uint32_t> begins);

  std::span<const Occurrence> operator[](SymbolId symbol) const {
    const auto i = static_cast<std::size_t>(symbol);
    return {occurrences_.data() + begins_[i], begins_[i + 1] - begins_[i]};
  }
  std::size_t size() const { return begins_.size() - 1; }  ///< symbols

  friend bool operator==(const Successors&, const Successors&) = default;

 private:
  std::vector<Occurrence> occurrences_;
  std::vector<std::uint32_t> begins_{0};
};

struct ActiveRules {
  std::vector<RuleIndex> rules;  ///< every rule whose clause holds, in order
  Successors joined;
};

/// Which clauses hold in `environment`, which has a value for every state, is
/// ClauseHolds' to say (compiler/truth.h). Copies: the genotype is not changed
/// (the authors' program joined the rules inside it, decision 0001).
ActiveRules Regulate(const Genotype& genotype, const Environment& environment);

/// The active rules of one symbol, in the order in which they are joined.
struct SymbolRules {
  SymbolId symbol{};
  std::vector<RuleIndex> active;  ///< none: the symbol stays as it is
};
/// Of every symbol that has rules, in alphabet order.
std::vector<SymbolRules> BySymbol(const Genotype& genotype,
                                  const ActiveRules& active);

}  // namespace plsc
