#pragma once

// Regulation for people: what each symbol is rewritten into in an environment,
// and the truth table over all environments that clauses tell apart. Rules
// have numbers from 1, in canonical order, as in `active_rules` of JSON.

#include <string>

#include "compiler/compile.h"
#include "compiler/state_space.h"

namespace plsc {

/// A line a symbol that has rules: its active rules (`-`, `2`, `1+3`) and what
/// they make of it together.
std::string RegulationText(const Genotype& genotype,
                           const NamedEnvironment& environment);

/// A row an environment: a column for each state that is asked about, and one
/// for each symbol that has rules. `-` is a gap: the symbol stays; `1+2` are
/// productions that are joined. `space` is the genotype's and has a size.
std::string RegulationTable(const Genotype& genotype, const StateSpace& space);

/// Which rule has which number: its symbol, its clause and its line.
std::string RuleLegend(const MappedProgram& compiled, const Source& source);

}  // namespace plsc
