#pragma once

// The words for the parts of a developed robot, the same wherever a person
// reads of them. Nodes are numbered from 1 there, as the phenotype's ids are.

#include <string>
#include <string_view>

#include "compiler/genotype.h"
#include "runtime/develop/derivation.h"
#include "sim/body.h"
#include "sim/brain.h"

namespace plsc {

/// `A2(0.5, 2.0, 3.0, 1.0)`.
std::string SymbolText(const Genotype& genotype, const Occurrence& occurrence);
/// The symbol's name alone.
const std::string& NameOf(const Genotype& genotype,
                          const Occurrence& occurrence);

std::string NodeName(int index);                     ///< "node3"
std::string EdgeName(const Connection& connection);  ///< "node1-node3"
// "front", "left", "right", "back":
std::string_view SlotName(Slot slot);
std::string_view FacingName(Facing facing);

}  // namespace plsc
