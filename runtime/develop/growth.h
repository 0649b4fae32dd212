#pragma once

// How long a derived string would be, without deriving it: rewriting is free
// of context, so counting symbols is enough. Microseconds for strings that
// would fill any memory.

#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/develop/regulate.h"

namespace plsc {

/// Length of the string after k rewritings; the greatest number of 64 bits
/// when it is that or more.
std::uint64_t DerivedLength(const Genotype& genotype,
                            const ActiveRules& active);

/// With `plasticoding` the string is C and then, for each rewriting, what the
/// rest of C's production has become: their lengths in that order, the newest,
/// which has not been rewritten, first. Empty without an active rule of C. The
/// string is within its limit.
std::vector<std::uint64_t> ReadingLengths(const Genotype& genotype,
                                          const ActiveRules& active);

/// A symbol whose active rules bring it back, more of it than of any other.
struct Multiplier {
  SymbolId symbol{};
  std::uint64_t copies = 0;  ///< of itself
  std::uint64_t length = 0;  ///< of all that it is rewritten into
};
/// Nothing when no symbol is rewritten into two or more of itself.
std::optional<Multiplier> GreatestMultiplier(const ActiveRules& active);

}  // namespace plsc
