#pragma once

// Early development: the symbol string that the active rules derive from the
// axiom in k parallel rewritings (paper, "Mapping stage 1").

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "runtime/develop/regulate.h"

namespace plsc {

using SymbolString = std::vector<Occurrence>;

/// Longest string a derivation may produce. Rules of 40 modules pass 10^6
/// symbols in 4 rewritings, and evolution finds such rules; without a limit
/// one child could take the whole machine. Raising it can change results.
inline constexpr std::size_t kMaxStringLength = 1u << 20;

/// Every replaceable symbol with active rules is replaced at once, `k` =
/// genotype.development.iterations times. Nothing when the string would grow
/// beyond kMaxStringLength.
std::optional<SymbolString> Derive(const Genotype& genotype,
                                   const ActiveRules& active);

/// The string before the last rewriting, of which there is one at least.
/// Nothing when the last would make it too long. For readers of the last
/// string that need not keep it: it is most of what a derivation writes.
std::optional<SymbolString> DeriveAllButLast(const Genotype& genotype,
                                             const ActiveRules& active);

/// What a rewriting puts in the place of `occurrence`: its successor, or
/// itself.
inline std::span<const Occurrence> RewrittenInto(const Successors& joined,
                                                 const Occurrence& occurrence) {
  const std::span<const Occurrence> successor = joined[occurrence.symbol];
  if (!successor.empty()) return successor;
  return {&occurrence, 1};
}

/// The string after each rewriting, the axiom first: k + 1 strings.
std::optional<std::vector<SymbolString>> DeriveSteps(const Genotype& genotype,
                                                     const ActiveRules& active);

}  // namespace plsc
