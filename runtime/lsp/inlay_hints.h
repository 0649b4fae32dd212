#pragma once

// textDocument/inlayHint: at the end of each clause's line, whether the rule is
// active in the chosen environment, and with how many others it is joined.

#include <string>

#include "runtime/lsp/analysis.h"
#include "runtime/lsp/json.h"

namespace plsc::lsp {

/// InlayHints of the rules that touch `span`. Rules without a clause get one
/// only where others are joined with them. None in a genotype for which
/// `environment` means nothing.
Json InlayHints(Analysis& analysis, Span span, const std::string& environment);

}  // namespace plsc::lsp
