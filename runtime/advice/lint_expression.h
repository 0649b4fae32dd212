#pragma once

// What development makes otherwise than it reads, found by developing the
// genotype in every regime: symbols and rules that never do anything (W4002),
// commands that change another joint than the one that they stand behind
// (W4003), rules of C that are read several times in one place (W4004).
// A symbol counts as expressed where it does
// something in late development (runtime/develop/effect.h) or is rewritten
// before: modules are often written only to call their rules. Symbols of
// alphabets without bodies are expressed wherever they stand in the final
// string.

#include <vector>

#include "compiler/compile.h"
#include "grammar/diagnostic.h"
#include "runtime/develop/regimes.h"

namespace plsc {

/// Most symbols over the strings of all regimes that are developed: four
/// strings of the longest kind. A genotype of the paper's kind has some
/// thousands.
inline constexpr std::uint64_t kMaxLintedSymbols = 1u << 22;

/// In every regime the string is within its limit. `file` is where to say
/// that there is too much to develop (W3005).
std::vector<Diagnostic> LintExpression(const MappedProgram& compiled,
                                       const StateSpace& space,
                                       const std::vector<Regime>& regimes,
                                       Span file);

}  // namespace plsc
