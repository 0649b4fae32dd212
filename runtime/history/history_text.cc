#include "runtime/history/history_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/print.h"
#include "compiler/truth.h"
#include "grammar/diagnostic.h"
#include "runtime/develop/part_names.h"
#include "runtime/history/event_text.h"

namespace plsc {

namespace {

constexpr std::size_t kWidestSymbol = 32;  // characters: A2 with four numbers

std::string ClauseText(const Genotype& genotype, const Clause& clause) {
  return clause.is_always() ? "always" : "if " + PrintClause(clause, genotype);
}

std::string RegulationText(const HistoryView& view) {
  const Genotype& genotype = view.genotype;
  std::string text = "rules:\n";
  for (std::size_t i = 0; i < genotype.rules.size(); ++i) {
    const Rule& rule = genotype.rules[i];
    const bool holds = ClauseHolds(rule.clause, view.environment.values);
    text += fmt::format(
        "  {} {} ({}), {}\n", holds ? "active    " : "not active",
        fmt::format("rule {} of {}", i + 1, genotype.SymbolOf(rule.head).name),
        ClauseText(genotype, rule.clause),
        PlaceText(view.source, view.map.rules[i].rule));
  }
  return text;
}

std::string DerivationText(const HistoryView& view) {
  const Derivation& derivation = view.history.derivation;
  std::string text = "rewritings:\n";
  for (std::size_t i = 0; i < derivation.steps.size(); ++i) {
    text += fmt::format("  Iteration {}:", i);
    for (const InsertionId id : derivation.steps[i])
      text += " " + SymbolText(view.genotype, derivation[id].occurrence);
    text += '\n';
  }
  return text;
}

std::string EventsText(const HistoryView& view) {
  const std::size_t count = view.history.derivation.string().size();
  const std::size_t digits = std::to_string(count).size();
  std::size_t width = 1;
  for (StringIndex i = 0; i < count; ++i)
    width = std::max(width,
                     SymbolText(view.genotype, view.At(i).occurrence).size());
  width = std::min(width, kWidestSymbol);
  std::string text = "symbols:\n";
  for (StringIndex i = 0; i < count; ++i)
    text += fmt::format("  {:>{}} {:{}}  {}\n", i + 1, digits,
                        SymbolText(view.genotype, view.At(i).occurrence), width,
                        EventText(view, i));
  return text;
}

// Which terms made the rule active; a single one is said in its clause.
std::string TermsText(const HistoryView& view, const Occurrence& occurrence) {
  if (occurrence.rule == kNoRule) return "";
  const Clause& clause = view.genotype.rules[occurrence.rule].clause;
  if (clause.terms.size() < 2) return "";
  std::string text;
  for (const Term& term : clause.terms) {
    const Clause alone{{term}, {}};
    if (!ClauseHolds(alone, view.environment.values)) continue;
    text += text.empty() ? "  = holds: " : ", ";
    text += PrintClause(alone, view.genotype);
  }
  return text + "\n";
}

}  // namespace

std::string RuleText(const Genotype& genotype, RuleIndex rule) {
  return fmt::format("rule {} ({}, {})", rule + 1,
                     genotype.SymbolOf(genotype.rules[rule].head).name,
                     ClauseText(genotype, genotype.rules[rule].clause));
}

std::string AncestryText(const HistoryView& view, InsertionId id) {
  std::string text;
  for (const InsertionId one : Ancestry(view.history.derivation, id)) {
    const Insertion& insertion = view.history.derivation[one];
    const Occurrence& occurrence = insertion.occurrence;
    if (one != id)
      text += fmt::format("in place of {}{}\n",
                          SymbolText(view.genotype, occurrence),
                          occurrence.rule == kNoRule ? ", the axiom" : "");
    const Span span = SpanOf(view, occurrence);
    if (span == Span{}) continue;
    const std::string label =
        occurrence.rule == kNoRule
            ? "the axiom"
            : fmt::format("inserted in iteration {} by {}", insertion.iteration,
                          RuleText(view.genotype, occurrence.rule));
    text += RenderPlace(span, label, view.source) + TermsText(view, occurrence);
  }
  return text;
}

std::string HistoryText(const HistoryView& view) {
  std::string text = RegulationText(view) + DerivationText(view);
  if (view.history.trace) text += EventsText(view);
  return text;
}

}  // namespace plsc
