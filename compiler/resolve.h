#pragma once

// Names to numbers: every symbol, state and value of the rules and the
// environments, found in the Scope. Parallel to the pools of the ast::File;
// what could not be found is reported here and skipped by what follows.

#include <optional>
#include <vector>

#include "compiler/expectation.h"
#include "compiler/scope.h"
#include "grammar/ast.h"

namespace plsc {

struct ResolvedArgument {
  double value = 0;
  bool is_integer = false;
  bool is_known = false;
};

/// A term's or an environment entry's state and value, value as in
/// Environment. Nothing when either is unknown or they do not fit.
using ResolvedTerm = std::optional<Term>;

struct ResolvedNode {
  std::optional<SymbolId> symbol;
  std::optional<Face> face;  ///< nothing for the first module too
};

struct Resolution {
  std::vector<std::optional<SymbolId>> heads;    ///< of File::rules
  std::vector<std::optional<SymbolId>> symbols;  ///< of File::symbols
  std::vector<ResolvedArgument> arguments;       ///< of File::arguments
  std::vector<ResolvedTerm> terms;               ///< of File::terms
  std::vector<ResolvedTerm> entries;             ///< of File::entries
  std::vector<ResolvedNode> nodes;               ///< of File::nodes
  std::vector<Diagnostic> diagnostics;
};

Resolution Resolve(const ast::File& file, const Scope& scope);

}  // namespace plsc
