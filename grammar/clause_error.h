#pragma once

// Clauses as other languages write them, and what clauses most often lack.

#include <optional>

#include "grammar/syntax_context.h"

namespace plsc {

/// '==', '&&', '!', parentheses: P1104 and P1114, when such a thing stands at
/// the place. Notes the other foreign words of the same clause.
std::optional<Diagnostic> DescribeForeign(SyntaxError error,
                                          const SyntaxContext& context);
Diagnostic DescribeMissingComparison(const SyntaxContext& context);
Diagnostic DescribeMissingThen(const SyntaxContext& context);

}  // namespace plsc
