#include "runtime/history/provenance_json.h"

#include "runtime/develop/part_names.h"
#include "runtime/history/history_json.h"
#include "runtime/history/provenance_text.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

Json OriginJson(const HistoryView& view, StringIndex index) {
  Json json = EventJson(view, index);
  json["ancestry"] =
      AncestryJson(view, view.history.derivation.string()[index]);
  return json;
}

Json FateJson(const HistoryView& view, const Fate& fate) {
  const bool is_replaced = fate.index == kNoIndex;
  const bool has_event = !is_replaced && view.history.trace;
  return {{"ancestry", AncestryJson(view, fate.insertion)},
          {"replaced_in", is_replaced ? Json(fate.replaced_in) : Json(nullptr)},
          {"index", is_replaced ? Json(nullptr) : Json(fate.index + 1)},
          {"event", has_event ? EventJson(view, fate.index) : Json(nullptr)}};
}

}  // namespace

Json PartJson(const HistoryView& view, const PhenotypePart& part,
              const std::optional<PartHistory>& found) {
  Json json;
  json[std::string(KindName(part.kind))] = found ? found->id : part.id;
  json["origin"] = found ? OriginJson(view, found->origin) : Json(nullptr);
  json["changes"] = Json::array();
  if (found)
    for (const StringIndex index : found->changes)
      json["changes"].push_back(OriginJson(view, index));
  return json;
}

Json FatesJson(const HistoryView& view, SymbolPlace place) {
  const Occurrence written = OccurrenceAt(view.genotype, place);
  Json json;
  json["symbol"] = SymbolText(view.genotype, written);
  json["place"] = PlaceJson(view.source, SpanOf(view, written));
  json["rule"] = RuleJson(view, place.rule);
  json["occurrences"] = Json::array();
  for (const Fate& fate :
       FatesOf(view.history.derivation, place.rule, place.position))
    json["occurrences"].push_back(FateJson(view, fate));
  return json;
}

}  // namespace plsc
