#include "runtime/lsp/navigation.h"

#include <algorithm>
#include <vector>

#include "runtime/lsp/params.h"

namespace plsc::lsp {

namespace {

// LSP's DocumentHighlightKind.
constexpr int kRead = 2;
constexpr int kWrite = 3;

Json LocationJson(const Analysis& analysis, Span span) {
  return {{"uri", analysis.uri()},
          {"range", RangeJson(analysis.lines().RangeOf(span))}};
}

std::vector<Mention> AllOf(Analysis& analysis, const Mention& wanted) {
  std::vector<Mention> found;
  for (const Mention& one : analysis.mentions())
    if (NameTheSame(one, wanted)) found.push_back(one);
  return found;
}

// Heads of the rules of a symbol, in the genotype that asks.
std::vector<Span> RulesOf(Analysis& analysis, const Mention& symbol) {
  const ast::File& file = analysis.SectionAt(symbol.span.begin).file;
  std::vector<Span> heads;
  for (const ast::Rule& rule : file.rules)
    if (file.Text(rule.head) == symbol.name) heads.push_back(rule.head);
  return heads;
}

}  // namespace

Json Definition(Analysis& analysis, std::uint32_t offset) {
  const Mention* at = analysis.MentionAt(offset);
  if (at == nullptr) return nullptr;
  Json locations = Json::array();
  if (at->is_declared())
    locations.push_back(LocationJson(analysis, at->declaration));
  if (at->kind == NameKind::kSymbol)
    for (const Span head : RulesOf(analysis, *at))
      locations.push_back(LocationJson(analysis, head));
  return locations;
}

Json References(Analysis& analysis, std::uint32_t offset,
                bool with_declaration) {
  const Mention* at = analysis.MentionAt(offset);
  if (at == nullptr) return nullptr;
  Json locations = Json::array();
  for (const Mention& one : AllOf(analysis, *at))
    if (with_declaration || !one.is_declaration())
      locations.push_back(LocationJson(analysis, one.span));
  return locations;
}

Json Highlights(Analysis& analysis, std::uint32_t offset) {
  const Mention* at = analysis.MentionAt(offset);
  if (at == nullptr) return nullptr;
  Json highlights = Json::array();
  for (const Mention& one : AllOf(analysis, *at))
    highlights.push_back(
        {{"range", RangeJson(analysis.lines().RangeOf(one.span))},
         {"kind", one.is_declaration() ? kWrite : kRead}});
  return highlights;
}

}  // namespace plsc::lsp
