#include "runtime/regulate.h"

#include <cassert>

#include "compiler/truth.h"

namespace plsc {

namespace {

// C is unique and first in every string, so only the first of the joined
// productions may bring it. The paper does not say so; its program does it.
bool IsLeadingCore(const Genotype& genotype, SymbolId head,
                   const Symbol& symbol, std::size_t position) {
  return genotype.alphabet->is_built_in() && head == plasticoding::kC &&
         symbol.id == plasticoding::kC && position == 0;
}

void Join(const Genotype& genotype, RuleIndex index,
          std::vector<Occurrence>& joined) {
  const Rule& rule = genotype.rules[index];
  const bool is_first = joined.empty();
  joined.reserve(joined.size() + rule.production.size());
  for (std::size_t i = 0; i < rule.production.size(); ++i) {
    const Symbol& symbol = rule.production[i];
    if (!is_first && IsLeadingCore(genotype, rule.head, symbol, i)) continue;
    joined.push_back({symbol.id, index, static_cast<std::uint32_t>(i)});
  }
}

}  // namespace

ActiveRules Regulate(const Genotype& genotype, const Environment& environment) {
  assert(environment.values.size() == genotype.states.size());
  assert(genotype.rules.size() < kNoRule);
  ActiveRules active;
  active.joined.resize(genotype.alphabet->symbols().size());
  for (std::size_t i = 0; i < genotype.rules.size(); ++i) {
    const Rule& rule = genotype.rules[i];
    if (!ClauseHolds(rule.clause, environment.values)) continue;
    const auto index = static_cast<RuleIndex>(i);
    active.rules.push_back(index);
    Join(genotype, index, active.joined[static_cast<std::size_t>(rule.head)]);
  }
  return active;
}

std::vector<SymbolRules> BySymbol(const Genotype& genotype,
                                  const ActiveRules& active) {
  std::vector<SymbolRules> symbols;
  for (const Rule& rule : genotype.rules)  // grouped by head
    if (symbols.empty() || symbols.back().symbol != rule.head)
      symbols.push_back({rule.head, {}});
  auto symbol = symbols.begin();
  for (const RuleIndex index : active.rules) {
    while (symbol->symbol != genotype.rules[index].head) ++symbol;
    symbol->active.push_back(index);
  }
  return symbols;
}

}  // namespace plsc
