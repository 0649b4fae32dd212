#include "runtime/lsp/outline.h"

#include <string>
#include <utility>
#include <vector>

#include "runtime/lsp/params.h"

namespace plsc::lsp {

namespace {

// LSP's SymbolKind.
enum class OutlineKind : int {
  kNamespace = 3,
  kClass = 5,
  kProperty = 7,
  kFunction = 12,
  kVariable = 13,
  kConstant = 14,
  kStruct = 23,
  kEvent = 24,
};

struct Entry {
  std::string name;
  std::string detail;
  OutlineKind kind{};
  Span span;
  Span name_span;
  std::vector<Entry> children;
};

std::string OneLine(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const bool is_blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!is_blank)
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  return line;
}

Entry EntryOf(const ast::File& file, const ast::Item& item) {
  using enum ast::ItemKind;
  Entry entry;
  entry.span = item.span;
  const auto name = [&](Span span, OutlineKind kind) {
    entry.name = file.Text(span);
    entry.name_span = span;
    entry.kind = kind;
  };
  switch (item.kind) {
    case kGenotype:
      name(file.genotypes[item.index].name, OutlineKind::kClass);
      break;
    case kAlphabet:
      name(file.alphabets[item.index].name, OutlineKind::kNamespace);
      entry.detail = "alphabet";
      break;
    case kSense:
      name(file.senses[item.index].name, OutlineKind::kVariable);
      entry.detail = "state";
      break;
    case kLet:
      name(file.lets[item.index].name, OutlineKind::kConstant);
      entry.detail = file.Text(file.lets[item.index].value.span);
      break;
    case kAxiom:
      name(file.axioms[item.index].name, OutlineKind::kProperty);
      entry.detail = "axiom";
      break;
    case kSetting:
      name(item.keyword, OutlineKind::kProperty);
      entry.detail = file.Text(file.settings[item.index].value.span);
      break;
    case kRule:
      name(file.rules[item.index].head, OutlineKind::kFunction);
      entry.detail = OneLine(file.Text(file.rules[item.index].clause));
      break;
    case kEnvironment:
      name(file.environments[item.index].name, OutlineKind::kStruct);
      entry.detail = "environment";
      break;
    case kTest:
      name(file.tests[item.index].name, OutlineKind::kEvent);
      entry.detail = "test";
      break;
  }
  return entry;
}

// Of several genotypes each holds what follows it; of one, all is beside it,
// because its item may stand anywhere.
std::vector<Entry> EntriesOf(const ast::File& file) {
  std::vector<Entry> entries;
  const bool has_several = file.genotypes.size() > 1;
  Entry* holder = nullptr;
  for (const ast::Item& item : file.items) {
    Entry entry = EntryOf(file, item);
    const bool begins = has_several && item.kind == ast::ItemKind::kGenotype;
    if (begins || holder == nullptr) {
      entries.push_back(std::move(entry));
      if (begins) holder = &entries.back();
    } else {
      holder->span.end = entry.span.end;
      holder->children.push_back(std::move(entry));
    }
  }
  return entries;
}

Json NestedJson(const Entry& entry, const LineTable& lines) {
  Json json = {{"name", entry.name},
               {"kind", static_cast<int>(entry.kind)},
               {"range", RangeJson(lines.RangeOf(entry.span))},
               {"selectionRange", RangeJson(lines.RangeOf(entry.name_span))}};
  if (!entry.detail.empty()) json["detail"] = entry.detail;
  for (const Entry& child : entry.children)
    json["children"].push_back(NestedJson(child, lines));
  return json;
}

Json FlatJson(const Entry& entry, const Analysis& analysis,
              const std::string& holder) {
  Json json = {{"name", entry.name}, {"kind", static_cast<int>(entry.kind)}};
  json["location"] = {
      {"uri", analysis.uri()},
      {"range", RangeJson(analysis.lines().RangeOf(entry.span))}};
  if (!holder.empty()) json["containerName"] = holder;
  return json;
}

}  // namespace

Json Outline(Analysis& analysis, bool is_nested) {
  Json symbols = Json::array();
  for (const Entry& entry : EntriesOf(analysis.file())) {
    if (is_nested) {
      symbols.push_back(NestedJson(entry, analysis.lines()));
      continue;
    }
    symbols.push_back(FlatJson(entry, analysis, ""));
    for (const Entry& child : entry.children)
      symbols.push_back(FlatJson(child, analysis, entry.name));
  }
  return symbols;
}

}  // namespace plsc::lsp
