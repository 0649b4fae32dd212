#pragma once

// Numbers as other languages write them, and what to write instead.

#include <optional>

#include "grammar/syntax_context.h"

namespace plsc {

/// At the place where digits had to follow ('2.', '1e').
Diagnostic DescribeMissingDigits(const SyntaxContext& context);
/// At the first byte that cannot continue a number ('0x1F', '1_000', '2px').
Diagnostic DescribeNumberEnd(const SyntaxContext& context);
/// At the place of a number, when something like one stands there ('+1',
/// '.5', '-inf').
std::optional<Diagnostic> DescribeNumberLike(const SyntaxContext& context);

/// 'nan', 'inf' and the like, in any case.
bool IsNotFiniteWord(std::string_view word);
/// P1111 for a whole text that is no number here.
Diagnostic NotANumber(std::string_view text, Span span);

}  // namespace plsc
