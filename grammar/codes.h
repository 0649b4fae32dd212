#pragma once

// Every diagnostic code of the language with one line about it: what the
// reference (docs/language.md) lists and `plsc explain` can show. P1 syntax,
// P2 names and types, P3 regulation, P5 files; W warnings.

#include <span>
#include <string_view>

namespace plsc {

struct CodeInfo {
  std::string_view code;
  std::string_view meaning;
};

/// Sorted: errors, then warnings.
std::span<const CodeInfo> DiagnosticCodes();

/// Empty when there is no such code.
std::string_view MeaningOf(std::string_view code);

}  // namespace plsc
