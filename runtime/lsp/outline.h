#pragma once

// textDocument/documentSymbol: genotypes with their states, constants, rules,
// environments and tests.

#include "runtime/lsp/analysis.h"
#include "runtime/lsp/json.h"

namespace plsc::lsp {

/// DocumentSymbols, nested; SymbolInformations for clients that know no nested
/// ones.
Json Outline(Analysis& analysis, bool is_nested);

}  // namespace plsc::lsp
