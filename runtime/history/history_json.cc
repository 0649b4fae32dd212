#include "runtime/history/history_json.h"

#include <algorithm>
#include <utility>

#include "compiler/print.h"
#include "compiler/truth.h"
#include "runtime/develop/part_names.h"
#include "runtime/history/event_text.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

Json EdgesJson(const Brain& brain, const Event& event) {
  Json edges = Json::array();
  const int end = event.edge + std::max(event.edge_count, 1);
  for (int i = event.edge; i < end; ++i)
    edges.push_back(EdgeName(brain.connections[static_cast<std::size_t>(i)]));
  return edges;
}

void AddParticulars(const Phenotype& phenotype, const Event& event,
                    Json& json) {
  if (event.module != kNoModule)
    json["module"] = ModuleId(phenotype.body, event.module);
  if (event.slot) {
    json["on"] = ModuleId(phenotype.body, event.reference);
    json["slot"] = SlotName(*event.slot);
  }
  if (event.node_before != kNoNode)
    json["node_before"] = NodeName(event.node_before);
  if (event.node != kNoNode) json["node"] = NodeName(event.node);
  if (event.edge != kNoEdge) json["edges"] = EdgesJson(phenotype.brain, event);
  if (event.effect == Effect::kEdgeChanged ||
      event.effect == Effect::kNeuronChanged) {
    json["before"] = event.before;
    json["after"] = event.after;
  }
  if (event.partner != kNoIndex) json["partner"] = event.partner + 1;
}

Json DerivationJson(const HistoryView& view) {
  const Derivation& derivation = view.history.derivation;
  Json symbols = Json::array();
  for (std::size_t i = 0; i < derivation.insertions.size(); ++i)
    symbols.push_back(InsertionJson(view, static_cast<InsertionId>(i)));
  Json steps = Json::array();
  for (const std::vector<InsertionId>& step : derivation.steps) {
    Json ids = Json::array();
    for (const InsertionId id : step) ids.push_back(id + 1);
    steps.push_back(std::move(ids));
  }
  return {{"symbols", std::move(symbols)}, {"steps", std::move(steps)}};
}

}  // namespace

Json PlaceJson(const Source& source, Span span) {
  if (span == Span{}) return nullptr;
  const Position at = source.PositionOf(span.begin);
  return {{"file", source.name()},
          {"line", at.line},
          {"column", at.column},
          {"byte_begin", span.begin},
          {"byte_end", span.end}};
}

Json RuleJson(const HistoryView& view, RuleIndex index) {
  const Rule& rule = view.genotype.rules[index];
  const RuleSpans& spans = view.map.rules[index];
  const std::vector<double>& values = view.environment.values;
  Json terms = Json::array();
  for (std::size_t i = 0; i < rule.clause.terms.size(); ++i) {
    const Clause alone{{rule.clause.terms[i]}, {}};
    terms.push_back({{"term", PrintClause(alone, view.genotype)},
                     {"holds", ClauseHolds(alone, values)},
                     {"place", PlaceJson(view.source, spans.terms[i])}});
  }
  return {{"rule", index + 1},
          {"head", view.genotype.SymbolOf(rule.head).name},
          {"clause", rule.clause.is_always()
                         ? Json(nullptr)
                         : Json(PrintClause(rule.clause, view.genotype))},
          {"active", ClauseHolds(rule.clause, values)},
          {"terms", std::move(terms)},
          {"place", PlaceJson(view.source, spans.rule)}};
}

Json InsertionJson(const HistoryView& view, InsertionId id) {
  const Insertion& insertion = view.history.derivation[id];
  const Occurrence& occurrence = insertion.occurrence;
  const bool is_axiom = occurrence.rule == kNoRule;
  return {
      {"id", id + 1},
      {"symbol", SymbolText(view.genotype, occurrence)},
      {"iteration", insertion.iteration},
      {"rule", is_axiom ? Json(nullptr) : Json(occurrence.rule + 1)},
      {"position", is_axiom ? Json(nullptr) : Json(occurrence.position + 1)},
      {"parent", is_axiom ? Json(nullptr) : Json(insertion.parent + 1)},
      {"place", PlaceJson(view.source, SpanOf(view, occurrence))}};
}

Json AncestryJson(const HistoryView& view, InsertionId id) {
  Json ancestry = Json::array();
  for (const InsertionId one : Ancestry(view.history.derivation, id)) {
    Json json = InsertionJson(view, one);
    const Occurrence& occurrence = view.history.derivation[one].occurrence;
    if (occurrence.rule != kNoRule) {
      const Json rule = RuleJson(view, occurrence.rule);
      json["clause"] = rule["clause"];
      json["terms"] = rule["terms"];
    }
    ancestry.push_back(std::move(json));
  }
  return ancestry;
}

Json EventJson(const HistoryView& view, StringIndex index) {
  const Trace& trace = *view.history.trace;
  const Event& event = trace.events[index];
  const Occurrence& occurrence = view.At(index).occurrence;
  Json json;
  json["index"] = index + 1;
  json["id"] = view.history.derivation.string()[index] + 1;
  json["symbol"] = SymbolText(view.genotype, occurrence);
  json["effect"] = InfoOf(event.effect).name;
  json["step"] = StepOf(occurrence.symbol);
  json["expressed"] = InfoOf(event.effect).is_expressed;
  json["text"] = EventText(view, index);
  AddParticulars(trace.phenotype, event, json);
  return json;
}

Json HistoryJson(const HistoryView& view) {
  Json json;
  json["regulation"] = Json::array();
  for (std::size_t i = 0; i < view.genotype.rules.size(); ++i)
    json["regulation"].push_back(RuleJson(view, static_cast<RuleIndex>(i)));
  json["derivation"] = DerivationJson(view);
  if (!view.history.trace) return json;
  json["events"] = Json::array();
  for (std::size_t i = 0; i < view.history.trace->events.size(); ++i)
    json["events"].push_back(EventJson(view, static_cast<StringIndex>(i)));
  return json;
}

}  // namespace plsc
