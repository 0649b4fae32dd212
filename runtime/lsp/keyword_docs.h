#pragma once

// A line about each reserved word, for hovers and completion. The reference is
// docs/language.md.

#include <string_view>

namespace plsc::lsp {

/// Empty when `word` is no keyword.
std::string_view KeywordDoc(std::string_view word);

}  // namespace plsc::lsp
