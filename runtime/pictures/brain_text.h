#pragma once

// A brain for a terminal: a line a node with its part and numbers, a line an
// edge with its weight.

#include <string>

#include "sim/phenotype.h"

namespace plsc {

/// Inputs, oscillators and edges, those of the first two in the order of their
/// modules. Lines end in a newline and carry no trailing blanks.
std::string BrainText(const Phenotype& phenotype);

/// Likewise, each line behind what it is to the reference: "━" not there, "═"
/// there with other numbers, "╌" (at the end, of the reference) there only.
std::string BrainText(const Phenotype& phenotype, const Phenotype& reference);

}  // namespace plsc
