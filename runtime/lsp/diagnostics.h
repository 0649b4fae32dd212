#pragma once

// Our diagnostics as LSP's: at most kMaxPublished of a document, those of the
// compiler first.

#include <vector>

#include "grammar/diagnostic.h"
#include "runtime/lsp/analysis.h"
#include "runtime/lsp/json.h"

namespace plsc::lsp {

/// More than anybody reads; editors become slow with many thousands.
inline constexpr std::size_t kMaxPublished = 500;

/// `is_advice`: of Lint, shown as information instead of as a warning.
Json DiagnosticToJson(const Diagnostic& diagnostic, const Analysis& analysis,
                      bool is_advice);

/// params of textDocument/publishDiagnostics.
Json PublishedJson(Analysis& analysis, std::int64_t version,
                   const std::vector<Diagnostic>& advice);

}  // namespace plsc::lsp
