#include "runtime/develop/part_names.h"

#include <fmt/format.h>

#include <array>

#include "compiler/print.h"

namespace plsc {

std::string SymbolText(const Genotype& genotype, const Occurrence& occurrence) {
  Symbol symbol{occurrence.symbol, {}};
  if (occurrence.rule != kNoRule)
    symbol = genotype.rules[occurrence.rule].production[occurrence.position];
  return PrintSymbol(symbol, *genotype.alphabet);
}

const std::string& NameOf(const Genotype& genotype,
                          const Occurrence& occurrence) {
  return (*genotype.alphabet)[occurrence.symbol].name;
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

}  // namespace plsc
