#pragma once

// Advice on programs that are right, by the truth tables of their clauses:
// what Compile does not warn of, because most random genotypes have it and
// mean it. What development has to say is in runtime/advice/lint.h.

#include <vector>

#include "compiler/program.h"
#include "compiler/source_map.h"
#include "grammar/diagnostic.h"

namespace plsc {

/// `map` says where the text is that `program` was compiled from.
///   W3003  a symbol has rules, but in some environment none is active, so
///          that it stays as it is there.
///   W3004  all rules of a symbol have clauses, yet in some environment
///          several hold, so that their productions are joined there.
///   W3005  the rules of a symbol tell apart too many environments.
/// Comments that silence warnings are not looked at (compiler/suppress.h).
std::vector<Diagnostic> LintClauses(const Program& program,
                                    const SourceMap& map);

}  // namespace plsc
