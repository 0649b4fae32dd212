#pragma once

// What can be wrong with the syntax of a genotype file, and how it is told.
// The parser only knows which rule was required and where; looking at the
// text around that place here is what makes the message specific.

#include "grammar/diagnostic.h"
#include "grammar/syntax_context.h"

namespace plsc {

Diagnostic DescribeSyntaxError(SyntaxError error, const SyntaxContext& context);

}  // namespace plsc
