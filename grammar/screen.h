#pragma once

// Is this a text at all? Looks at the bytes of a source before it is parsed,
// so that a binary file, another encoding or an unresolved merge gets one
// message that names it instead of many that do not.

#include <optional>

#include "grammar/diagnostic.h"

namespace plsc {

/// Longest text that is parsed. The longest evolved genotypes have some 10 kB;
/// the limit keeps spans in 32 bits and hostile files out of memory.
inline constexpr std::size_t kMaxSourceBytes = std::size_t{16} << 20;

/// The reason why this is not the text of a genotype, or nothing.
std::optional<Diagnostic> Screen(const Source& source);

}  // namespace plsc
