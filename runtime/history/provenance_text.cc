#include "runtime/history/provenance_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/develop/part_names.h"
#include "runtime/history/event_text.h"
#include "runtime/history/history_text.h"

namespace plsc {

namespace {

std::string OriginText(const HistoryView& view, StringIndex index) {
  const Derivation& derivation = view.history.derivation;
  return fmt::format("symbol {} of {}, {}: {}\n", index + 1,
                     derivation.string().size(),
                     NameOf(view.genotype, view.At(index).occurrence),
                     EventText(view, index)) +
         AncestryText(view, derivation.string()[index]);
}

// Why the symbol never is in a string.
std::string AbsenceText(const HistoryView& view, RuleIndex rule) {
  const std::vector<RuleIndex>& active = view.history.active.rules;
  if (std::find(active.begin(), active.end(), rule) == active.end())
    return RuleText(view.genotype, rule) + " is not active";
  const SymbolId head = view.genotype.rules[rule].head;
  const std::vector<Insertion>& all = view.history.derivation.insertions;
  const bool is_head_replaced =
      std::any_of(all.begin(), all.end(), [&](const Insertion& insertion) {
        return insertion.occurrence.symbol == head && insertion.child_count > 0;
      });
  // Regulate leaves out nothing else.
  if (is_head_replaced)
    return "left out, as the first active rule of C brings the core";
  return fmt::format("no rewriting meets a {}, so {} is never used",
                     view.genotype.SymbolOf(head).name,
                     RuleText(view.genotype, rule));
}

std::string FateText(const HistoryView& view, const Fate& fate) {
  const Derivation& derivation = view.history.derivation;
  std::string text = fmt::format("  inserted in iteration {} for",
                                 derivation[fate.insertion].iteration);
  const std::vector<InsertionId> line = Ancestry(derivation, fate.insertion);
  for (std::size_t i = 1; i < line.size(); ++i)
    text += (i == 1 ? " " : " < ") +
            NameOf(view.genotype, derivation[line[i]].occurrence);
  if (fate.index == kNoIndex)
    return text + fmt::format("; replaced in iteration {}\n", fate.replaced_in);
  text += fmt::format("; symbol {} of {}", fate.index + 1,
                      derivation.string().size());
  if (view.history.trace) text += ": " + EventText(view, fate.index);
  return text + "\n";
}

}  // namespace

std::string_view KindName(PartKind kind) {
  switch (kind) {
    case PartKind::kModule:
      return "module";
    case PartKind::kNode:
      return "node";
    case PartKind::kEdge:
      break;
  }
  return "edge";
}

Occurrence OccurrenceAt(const Genotype& genotype, SymbolPlace place) {
  const Rule& rule = genotype.rules[place.rule];
  return {rule.production[place.position].id, place.rule, place.position};
}

std::string PartText(const HistoryView& view, const PartHistory& part) {
  std::string text = OriginText(view, part.origin);
  for (const StringIndex index : part.changes)
    text += "changed by " + OriginText(view, index);
  return text;
}

std::string FatesText(const HistoryView& view, SymbolPlace place) {
  const std::vector<Fate> fates =
      FatesOf(view.history.derivation, place.rule, place.position);
  if (fates.empty()) return "  " + AbsenceText(view, place.rule) + "\n";
  std::string text;
  for (const Fate& fate : fates) text += FateText(view, fate);
  return text;
}

}  // namespace plsc
