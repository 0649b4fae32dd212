#pragma once

// textDocument/hover: symbols with their documentation, states, constants,
// environments and keywords; anywhere in a clause its truth table, too.

#include "runtime/lsp/analysis.h"
#include "runtime/lsp/json.h"

namespace plsc::lsp {

/// A Hover, or null where there is nothing to say.
Json Hover(Analysis& analysis, std::uint32_t offset);

}  // namespace plsc::lsp
