#pragma once

// Renaming what a file declares: states, constants, environments, tests,
// genotypes, values, symbols and parameters of its own alphabet. Of texts that
// compile only, and only to texts that compile and mean the same.

#include <string>

#include "runtime/lsp/analysis.h"
#include "runtime/lsp/json.h"

namespace plsc::lsp {

/// {range, placeholder}; null when there is nothing to rename at `offset`.
Json PrepareRename(Analysis& analysis, std::uint32_t offset);

/// A WorkspaceEdit; a Fault that says why when it cannot be done.
Json Rename(Analysis& analysis, std::uint32_t offset, const std::string& name);

}  // namespace plsc::lsp
