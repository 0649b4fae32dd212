#pragma once

// textDocument/completion: what may stand at the cursor
// (completion_context.h), with the names that the genotype has.

#include "runtime/lsp/analysis.h"
#include "runtime/lsp/json.h"

namespace plsc::lsp {

/// CompletionItems. `has_snippets`: the client fills in places of a template.
Json Completion(Analysis& analysis, std::uint32_t offset, bool has_snippets);

}  // namespace plsc::lsp
