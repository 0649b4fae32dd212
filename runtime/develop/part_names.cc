#include "runtime/develop/part_names.h"

#include <fmt/format.h>

#include <array>

#include "compiler/print.h"

namespace plsc {

std::string SymbolText(const Genotype& genotype, const Occurrence& occurrence) {
  return PrintSymbol(SymbolAt(genotype, occurrence), *genotype.alphabet);
}

const std::string& NameOf(const Genotype& genotype,
                          const Occurrence& occurrence) {
  return genotype.SymbolOf(occurrence.symbol).name;
}

std::string NodeName(int index) {
  return fmt::format("node{}", index + 1);
}

std::string EdgeName(const Connection& connection) {
  return NodeName(connection.source) + "-" + NodeName(connection.destination);
}

std::string_view SlotName(Slot slot) {
  // By Slot.
  constexpr std::array<std::string_view, kSlots> kNames{"back", "front",
                                                        "right", "left"};
  return kNames[static_cast<std::size_t>(slot)];
}

std::string_view FacingName(Facing facing) {
  // By Facing.
  constexpr std::array<std::string_view, 4> kNames{"front", "left", "back",
                                                   "right"};
  return kNames[static_cast<std::size_t>(facing)];
}

}  // namespace plsc
