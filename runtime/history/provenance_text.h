#pragma once

// Answers to "why?" for people.

#include <string>
#include <string_view>

#include "runtime/develop/provenance.h"
#include "runtime/history/history_view.h"

namespace plsc {

std::string_view KindName(PartKind kind);  ///< "module", "node", "edge"

/// The symbol of the genotype at that place.
Occurrence OccurrenceAt(const Genotype& genotype, SymbolPlace place);

/// Back: the symbol that made the part, those that changed it, each with its
/// place, its rule and iteration and what it was inserted for.
std::string PartText(const HistoryView& view, const PartHistory& part);

/// Forward: a line an occurrence; or why there is none.
std::string FatesText(const HistoryView& view, SymbolPlace place);

}  // namespace plsc
