#pragma once

// The text around a place where parsing stopped: which word stands there,
// what came before. For messages only; the parser does not decide by it.

#include <string>
#include <string_view>

#include "grammar/source.h"
#include "grammar/syntax_context.h"

namespace plsc {

/// What stands at the place of a syntax error.
struct Found {
  Span span;              ///< empty at the end of the file
  std::string_view text;  ///< a word, a number, an operator or one character
  std::string quoted;     ///< "'text'", or "the end of the file"
  bool is_end = false;
};

Found FoundAt(std::string_view text, std::uint32_t offset);
/// The token that ends at `end`, and its bytes.
Found FoundBefore(std::string_view text, std::uint32_t end);

/// Where the caret goes for "expected X": at what was found when that is on
/// the line of the token before it, else right behind that token.
Span CaretOf(const SyntaxContext& context);

/// Whether an item starts at `found`, or the file ends: whatever was open
/// has not been closed.
bool IsItemOrEnd(const Found& found);

/// Other languages' word for one of plsc ("&&" for "and"), or empty.
std::string_view PlscWordFor(std::string_view foreign);

}  // namespace plsc
