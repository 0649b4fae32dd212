#pragma once

// What hovers and completion say about things, as Markdown.

#include <string>

#include "compiler/alphabet.h"
#include "compiler/genotype.h"
#include "compiler/program.h"

namespace plsc::lsp {

/// `A1(w in -1..1, a in 1..10)`: as one would write its declaration.
std::string SignatureOf(const SymbolInfo& symbol);
/// Its signature, what it does, what each parameter means.
std::string DescribeSymbol(const SymbolInfo& symbol);
/// `w`: its range and meaning, on one line.
std::string DescribeParameter(const Parameter& parameter);
/// `sense inclined: bool`, as code.
std::string DescribeState(const State& state);
std::string DescribeEnvironment(const NamedEnvironment& environment,
                                const std::vector<State>& states);

/// In which environments the clause holds, a row each, at most kMaxTruthRows.
std::string TruthMarkdown(const Clause& clause,
                          const std::vector<State>& states);
/// What fits a hover.
inline constexpr int kMaxTruthRows = 32;

}  // namespace plsc::lsp
