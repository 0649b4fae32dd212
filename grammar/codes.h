#pragma once

// Every diagnostic code with one line about it: what the reference
// (docs/language.md) lists. `plsc explain` has more to say of each
// (runtime/cli/explanations/explanations.h). P1 syntax, P2 names and types, P3
// regulation, P4 development, P5 files, P51 scenarios and experiments; W
// warnings.

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
