#pragma once

// A development with its history as JSON (docs/formats.md). Rules, symbols of
// the string and inserted symbols are numbered from 1; modules, nodes and edges
// have the ids of the phenotype.

#include <nlohmann/json.hpp>

#include "runtime/history/history_view.h"

namespace plsc {

/// Keys regulation, derivation and, when the alphabet has bodies, events.
nlohmann::ordered_json HistoryJson(const HistoryView& view);

/// Keys rule, head, clause, active, terms (term, holds, place), place.
nlohmann::ordered_json RuleJson(const HistoryView& view, RuleIndex rule);

/// Keys file, line, column, byte_begin, byte_end; null for an empty span.
nlohmann::ordered_json PlaceJson(const Source& source, Span span);

/// Keys index, id, symbol, effect, step, expressed, text, and what belongs to
/// the effect: module, on, slot, node, edges, before, after, partner.
nlohmann::ordered_json EventJson(const HistoryView& view, StringIndex index);

/// Keys id, symbol, iteration, rule, position, parent, place.
nlohmann::ordered_json InsertionJson(const HistoryView& view, InsertionId id);

/// The insertion and what it was inserted for, up to the axiom; each but the
/// axiom also with the clause and terms of its rule.
nlohmann::ordered_json AncestryJson(const HistoryView& view, InsertionId id);

}  // namespace plsc
