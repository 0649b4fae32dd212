#pragma once

// Advice on programs that are right: what Compile does not warn of, because
// most random genotypes have it and mean it.

#include <vector>

#include "compiler/program.h"
#include "grammar/diagnostic.h"
#include "grammar/source.h"

namespace plsc {

/// `source` is what `program` was compiled from (or printed to): the warnings
/// point into it.
///   W3003  a symbol has rules, but in some environment none is active, so
///          that it stays as it is there.
std::vector<Diagnostic> Lint(const Program& program, const Source& source);

}  // namespace plsc
