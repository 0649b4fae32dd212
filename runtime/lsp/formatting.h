#pragma once

// textDocument/formatting: `plsc fmt` of the editor's text.

#include "runtime/lsp/analysis.h"
#include "runtime/lsp/json.h"

namespace plsc::lsp {

/// TextEdits; null when the text is broken: what cannot be read cannot be laid
/// out.
Json FormattingEdits(const Analysis& analysis);

}  // namespace plsc::lsp
