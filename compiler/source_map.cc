#include "compiler/source_map.h"

#include "compiler/lower.h"

namespace plsc {

namespace {

RuleSpans SpansOf(const ast::File& file, const ast::Rule& rule, Span item) {
  RuleSpans spans;
  spans.rule = item;
  spans.head = rule.head;
  spans.clause = rule.clause;
  spans.terms.reserve(rule.terms.count);
  for (const ast::Term& term : ast::Slice(file.terms, rule.terms))
    spans.terms.push_back(term.span);
  spans.symbols.reserve(rule.symbols.count);
  for (const ast::Symbol& symbol : ast::Slice(file.symbols, rule.symbols))
    spans.symbols.push_back(symbol.span);
  return spans;
}

TestSpans SpansOf(const ast::File& file, const ast::Test& test, Span item) {
  TestSpans spans{item, test.name, test.close, {}, {}};
  for (const ast::Symbol& symbol : ast::Slice(file.symbols, test.symbols))
    spans.symbols.push_back(symbol.span);
  for (const ast::BodyNode& node : ast::Slice(file.nodes, test.nodes)) {
    const Span first = node.depth > 0 ? node.face : node.name;
    spans.modules.push_back({first.begin, node.name.end});
  }
  return spans;
}

bool Covers(Span span, std::uint32_t offset) {
  return span.begin <= offset && offset < span.end;
}

}  // namespace

SourceMap MapSource(const ast::File& file, const Resolution& resolution) {
  std::vector<Span> items(file.rules.size());
  for (const ast::Item& item : file.items)
    if (item.kind == ast::ItemKind::kRule) items[item.index] = item.span;
  SourceMap map;
  map.rules.reserve(file.rules.size());
  for (const std::size_t index : RuleOrder(resolution))
    map.rules.push_back(SpansOf(file, file.rules[index], items[index]));
  if (!file.axioms.empty()) map.axiom = file.axioms.front().name;
  map.version = file.version;
  for (const ast::Setting& setting : file.settings)
    if (setting.key == ast::SettingKey::kIterations)
      map.iterations = setting.value.span;
  if (!file.genotypes.empty()) map.genotype = file.genotypes.front().name;
  for (const ast::Item& item : file.items)
    if (item.kind == ast::ItemKind::kTest)
      map.tests.push_back(SpansOf(file, file.tests[item.index], item.span));
  return map;
}

std::optional<SymbolPlace> FindSymbol(const SourceMap& map,
                                      std::uint32_t offset) {
  for (std::size_t rule = 0; rule < map.rules.size(); ++rule) {
    const RuleSpans& spans = map.rules[rule];
    if (!Covers(spans.rule, offset)) continue;
    for (std::size_t i = 0; i < spans.symbols.size(); ++i)
      if (Covers(spans.symbols[i], offset))
        return SymbolPlace{static_cast<std::uint16_t>(rule),
                           static_cast<std::uint32_t>(i)};
  }
  return std::nullopt;
}

}  // namespace plsc
