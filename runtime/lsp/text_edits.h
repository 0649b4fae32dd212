#pragma once

// A changed text as one edit of what differs, so that an editor keeps its
// cursor, folds and marks elsewhere.

#include <string>
#include <string_view>

#include "runtime/lsp/analysis.h"
#include "runtime/lsp/json.h"

namespace plsc::lsp {

/// A list of TextEdits: none when nothing differs. Begins and ends at ends of
/// lines, or at the text's.
Json EditsTo(const Analysis& analysis, std::string_view changed);

}  // namespace plsc::lsp
