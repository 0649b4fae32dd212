#pragma once

// Sizes beyond which a genotype is refused, and the ranges of its settings.
// Compile reports them at their place; Verify holds everybody else to them.

#include <cstddef>

namespace plsc {

/// Rules are numbered in 16 bits while developing, and one number means "no
/// rule" (runtime/develop/regulate.h).
inline constexpr std::size_t kMaxRuleCount = 0xFFFE;
/// StateId and SymbolId have 16 bits; a thousand is far beyond any robot's
/// senses and keeps searches for similar names cheap in hostile files.
inline constexpr std::size_t kMaxStates = 1000;
inline constexpr std::size_t kMaxSymbols = 1000;

/// Of `iterations`; strings grow exponentially with it, so the upper bound
/// only keeps it a small number (development has its own limit of length).
inline constexpr int kMinIterations = 0;
inline constexpr int kMaxIterations = 100;
/// Of `max_modules`; the core always exists.
inline constexpr int kMinModules = 1;
inline constexpr int kMaxModules = 1000;
/// Of `max_terms` and `max_rules`.
inline constexpr int kMinLimit = 1;
inline constexpr int kMaxLimit = 1000;

/// Bytes of what several genotypes of a file share, times their number: each
/// gets a copy. As much as a file of the largest size, so that memory stays
/// within what such a file takes.
inline constexpr std::size_t kMaxSharedText = std::size_t{16} << 20U;

/// 2^53: whole numbers up to here are doubles exactly.
inline constexpr double kMaxWholeNumber = 9007199254740992.0;

/// Name of a genotype whose file does not name it.
inline constexpr const char* kUnnamed = "unnamed";

}  // namespace plsc
