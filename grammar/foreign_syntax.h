#pragma once

// What stands at the place of a syntax error though plsc has nothing of the
// kind: characters that only look right, and ways of other languages to write
// things. Adds to a message how to write them here.

#include "grammar/syntax_context.h"

namespace plsc {

/// Replaces the diagnostic by one that names a character that looks like
/// another or is invisible, or adds to it the help that a construct of another
/// language needs. Nothing when it knows neither.
void ExplainForeignSyntax(SyntaxError error, const SyntaxContext& context,
                          Diagnostic* diagnostic);

}  // namespace plsc
