#pragma once

// textDocument/semanticTokens: colours by meaning. Words that name nothing
// known keep the colours of the editor's own grammar.

#include "runtime/lsp/analysis.h"
#include "runtime/lsp/json.h"

namespace plsc::lsp {

/// {tokenTypes, tokenModifiers}: what the numbers of the answers mean.
Json SemanticTokensLegend();

/// {data}: five numbers a token that touches `span`.
Json SemanticTokens(Analysis& analysis, Span span);

}  // namespace plsc::lsp
