#pragma once

// Answers to "why?" as JSON objects (docs/formats.md).

#include <nlohmann/json.hpp>
#include <optional>

#include "runtime/develop/provenance.h"
#include "runtime/history/history_view.h"

namespace plsc {

/// Keys module, node or edge (the id), origin and changes: symbols as in
/// EventJson, each with its ancestry. Without `found` origin is null.
nlohmann::ordered_json PartJson(const HistoryView& view,
                                const PhenotypePart& part,
                                const std::optional<PartHistory>& found);

/// Keys symbol, place, rule, occurrences (ancestry, replaced_in, index, event).
nlohmann::ordered_json FatesJson(const HistoryView& view, SymbolPlace place);

}  // namespace plsc
