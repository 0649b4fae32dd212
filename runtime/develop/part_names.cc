#include "runtime/develop/part_names.h"

#include <fmt/format.h>

#include "compiler/print.h"
#include "grammar/enum_names.h"

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
  constexpr EnumNames<Slot, kSlots> kNames{{{Slot::kBack, "back"},
                                            {Slot::kFront, "front"},
                                            {Slot::kRight, "right"},
                                            {Slot::kLeft, "left"}}};
  return NameIn(kNames, slot);
}

std::string_view FacingName(Facing facing) {
  constexpr EnumNames<Facing, 4> kNames{{{Facing::kFront, "front"},
                                         {Facing::kLeft, "left"},
                                         {Facing::kBack, "back"},
                                         {Facing::kRight, "right"}}};
  return NameIn(kNames, facing);
}

}  // namespace plsc
