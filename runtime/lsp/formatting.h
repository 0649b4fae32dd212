#pragma once

// textDocument/formatting and rangeFormatting: `plsc fmt` of the editor's text,
// or those of its changes that are in some lines.

#include "runtime/lsp/analysis.h"
#include "runtime/lsp/json.h"

namespace plsc::lsp {

/// TextEdits; null when the text is broken: what cannot be read cannot be laid
/// out.
Json FormattingEdits(const Analysis& analysis);

/// Of the lines `first` to `last`, from 0; what would move from or to other
/// lines stays. Null as above, and where no part of the layout can be made
/// alone.
Json FormattingEdits(const Analysis& analysis, std::uint32_t first,
                     std::uint32_t last);

}  // namespace plsc::lsp
