#pragma once

// textDocument/foldingRange: genotypes of a file with several, items of more
// than a line, runs of comments.

#include "runtime/lsp/analysis.h"
#include "runtime/lsp/json.h"

namespace plsc::lsp {

/// FoldingRanges by where they begin. The line of a closing brace stays.
Json FoldingRanges(Analysis& analysis);

}  // namespace plsc::lsp
