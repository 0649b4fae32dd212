#pragma once

// A brain for a terminal: a line a node with its part and numbers, a line an
// edge with its weight.

#include <string>

#include "sim/phenotype.h"

namespace plsc {

/// Inputs, oscillators and edges, those of the first two in the order of their
/// modules. Lines end in a newline and carry no trailing blanks.
std::string BrainText(const Phenotype& phenotype);

}  // namespace plsc
