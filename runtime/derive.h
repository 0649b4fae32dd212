#pragma once

// Early development: the symbol string that the active rules derive from the
// axiom in k parallel rewritings (paper, "Mapping stage 1").

#include <cstddef>
#include <optional>
#include <vector>

#include "runtime/regulate.h"

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

/// The string after each rewriting, the axiom first: k + 1 strings.
std::optional<std::vector<SymbolString>> DeriveSteps(const Genotype& genotype,
                                                     const ActiveRules& active);

}  // namespace plsc
