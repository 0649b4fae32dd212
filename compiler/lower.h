#pragma once

// Syntax tree to IR, once everything is resolved and checked: nothing can be
// wrong here any more. Rules are grouped by head in alphabet order, within a
// head in file order.

#include "compiler/program.h"
#include "compiler/resolve.h"

namespace plsc {

Program Lower(const ast::File& file, const Scope& scope,
              const Resolution& resolution);

Clause LowerClause(const ast::File& file, const ast::Rule& rule,
                   const Resolution& resolution);

/// Indices of File::rules in the order of Genotype::rules.
std::vector<std::size_t> RuleOrder(const Resolution& resolution);

}  // namespace plsc
