#pragma once

// "Did you mean ...?": the known word nearest to what was written.

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "grammar/diagnostic.h"

namespace plsc {

/// Edits (insert, delete, replace, swap of neighbours) from `a` to `b`; the
/// restricted Damerau-Levenshtein distance.
int EditDistance(std::string_view a, std::string_view b);

/// The nearest of `known`, if at most 2 edits and at most a third of the
/// word's length away, or the same but for case; the first among equals.
std::optional<std::string> Suggest(std::string_view word,
                                   std::span<const std::string_view> known);

/// Says so beside the caret, with the fix, when there is one near to what
/// stands there.
bool AddSuggestion(std::string_view word,
                   std::span<const std::string_view> known,
                   Diagnostic* diagnostic);

}  // namespace plsc
