#pragma once

// Checks of the symbols of productions: arguments and the core's place.

#include <vector>

#include "compiler/compile.h"
#include "compiler/resolve.h"

namespace plsc {

std::vector<Diagnostic> CheckSymbols(const ast::File& file, const Scope& scope,
                                     const Resolution& resolution,
                                     const CompileOptions& options);

}  // namespace plsc
