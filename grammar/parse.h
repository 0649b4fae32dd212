#pragma once

// Text to syntax tree; no meaning. The only door to PEGTL.

#include <vector>

#include "grammar/ast.h"
#include "grammar/diagnostic.h"
#include "grammar/source.h"

namespace plsc {

struct ParseResult {
  ast::File file;  ///< items that parsed, also when others did not
  std::vector<Diagnostic> diagnostics;  ///< errors, one an item at most
};

/// The tree refers to the source's text, which must outlive it.
ParseResult Parse(const Source& source);

}  // namespace plsc
