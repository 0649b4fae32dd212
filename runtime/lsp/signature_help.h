#pragma once

// textDocument/signatureHelp: the parameters of the symbol whose arguments are
// being written, and which of them is next.

#include "runtime/lsp/analysis.h"
#include "runtime/lsp/json.h"

namespace plsc::lsp {

/// A SignatureHelp of one signature; null outside of arguments, also of texts
/// that are not whole.
Json SignatureHelp(Analysis& analysis, std::uint32_t offset);

}  // namespace plsc::lsp
