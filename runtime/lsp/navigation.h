#pragma once

// Definition, references and highlights: answers of the list of mentions.

#include "runtime/lsp/analysis.h"
#include "runtime/lsp/json.h"

namespace plsc::lsp {

/// Locations: where the name at `offset` is declared; of a symbol also its
/// rules, which say what becomes of it. Null when there is no name.
Json Definition(Analysis& analysis, std::uint32_t offset);

/// Locations of all that names the same; null when there is no name.
Json References(Analysis& analysis, std::uint32_t offset,
                bool with_declaration);

/// The same as DocumentHighlights.
Json Highlights(Analysis& analysis, std::uint32_t offset);

}  // namespace plsc::lsp
