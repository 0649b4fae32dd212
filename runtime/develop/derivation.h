#pragma once

// Early development with its history: for each symbol the rewriting that
// inserted it and the symbol that it was inserted for. For people who ask why;
// Derive is the fast way to the same string.

#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/develop/derive.h"

namespace plsc {

/// Index into Derivation::insertions.
using InsertionId = std::uint32_t;
inline constexpr InsertionId kNoInsertion = 0xFFFFFFFF;

/// One symbol from when a rewriting inserted it until another replaces it. A
/// symbol without active rules stays the same insertion to the end.
struct Insertion {
  Occurrence occurrence;
  int iteration = 0;                       ///< 0 the axiom, then 1 to k
  InsertionId parent = kNoInsertion;       ///< what it (partly) replaced
  InsertionId first_child = kNoInsertion;  ///< of what replaced it
  std::uint32_t child_count = 0;
};

struct Derivation {
  std::vector<Insertion> insertions;  ///< in order of insertion, axiom first
  /// The string after each rewriting, axiom first.
  std::vector<std::vector<InsertionId>> steps;

  const std::vector<InsertionId>& string() const { return steps.back(); }
  const Insertion& operator[](InsertionId id) const { return insertions[id]; }
};

/// Most symbols over all strings of a derivation that is kept whole: eight
/// strings of the greatest length, at most some 0.4 GB. Only programs made to
/// be hostile come near it.
inline constexpr std::size_t kMaxKeptSymbols = 8 * kMaxStringLength;

/// The same rewritings as Derive. Nothing when Derive gives nothing, or when
/// there would be more than kMaxKeptSymbols to keep.
std::optional<Derivation> DeriveWithHistory(const Genotype& genotype,
                                            const ActiveRules& active);

/// The symbols of the final string.
SymbolString FinalString(const Derivation& derivation);

/// `id` and what it was inserted for, up to the axiom.
std::vector<InsertionId> Ancestry(const Derivation& derivation, InsertionId id);

}  // namespace plsc
