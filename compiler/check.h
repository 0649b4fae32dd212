#pragma once

// What is wrong with a file whose names are all found: numbers and types of
// arguments, their ranges, the core's place, limits, environments. Everything
// found is reported; nothing is changed.

#include <vector>

#include "compiler/compile_options.h"
#include "compiler/resolve.h"

namespace plsc {

std::vector<Diagnostic> Check(const ast::File& file, const Scope& scope,
                              const Resolution& resolution,
                              const CompileOptions& options);

/// Warnings on clauses that hold always or never (W3002), for a file without
/// errors.
std::vector<Diagnostic> CheckClauses(const ast::File& file, const Scope& scope,
                                     const Resolution& resolution);

}  // namespace plsc
