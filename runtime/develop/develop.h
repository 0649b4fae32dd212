#pragma once

// Late development: from the symbol string to body and brain, by two turtles
// that read it once from left to right (paper, "Mapping stage 2";
// docs/development.md). body_turtle and brain_turtle hold the rules; this is
// the door.

#include <optional>

#include "runtime/develop/derive.h"
#include "sim/phenotype.h"

namespace plsc {

/// The genotype uses the plasticoding alphabet, and the string starts with C.
Phenotype Develop(const Genotype& genotype, const SymbolString& string);

/// Regulate, Derive and Develop in one call. Nothing when the string would
/// grow beyond its limit.
std::optional<Phenotype> Develop(const Genotype& genotype,
                                 const Environment& environment);

}  // namespace plsc
