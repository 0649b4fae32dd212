#pragma once

// Checks of the symbols of productions: arguments and the core's place.

#include <string>

#include "compiler/compile_options.h"
#include "compiler/resolve.h"
#include "grammar/reporter.h"

namespace plsc {

void CheckSymbols(const ast::File& file, const Scope& scope,
                  const Resolution& resolution, const CompileOptions& options,
                  Reporter* reporter);

/// `A1(w in -1..1, a in 1..10, p in 1..10, o in 1..10)`, for messages.
std::string Signature(const SymbolInfo& symbol);

}  // namespace plsc
