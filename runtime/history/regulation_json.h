#pragma once

// Regulation for scripts: the same as regulation_text.h, one JSON object an
// environment (docs/formats.md).

#include <string>

#include "compiler/program.h"
#include "compiler/state_space.h"

namespace plsc {

/// Keys: genotype, environment (state -> value), active_rules (numbers from
/// 1), symbols (symbol -> rules and, unless it stays, joined). Without the end
/// of the line.
std::string RegulationJson(const Genotype& genotype,
                           const NamedEnvironment& environment);

/// Row `index` of the truth table. Keys: genotype, when (state -> the values
/// that the row is for: a list, or low, high and whether they belong to it),
/// environment (one of them), active_rules, symbols (symbol -> numbers).
std::string RegulationRowJson(const Genotype& genotype, const StateSpace& space,
                              int index);

}  // namespace plsc
