#pragma once

// textDocument/codeAction: the fixes of diagnostics one by one, a comment that
// silences a warning, and all that `plsc fix` would mend as one source action.

#include <string>
#include <vector>

#include "grammar/diagnostic.h"
#include "runtime/lsp/analysis.h"
#include "runtime/lsp/json.h"

namespace plsc::lsp {

/// For the places [range] of params, of the kinds that its context asks for.
/// `advice` is what Lint said of the document.
Json CodeActions(Analysis& analysis, const std::vector<Diagnostic>& advice,
                 const Json& params);

}  // namespace plsc::lsp
