// A clause at a time, in the order of the genotype's rules, which are grouped
// by head: so the successors of all symbols are appended to one array and only
// their beginnings are noted. Where several rules of a symbol hold, their
// productions are joined in that order (paper, "Environmental regulation";
// authors' program, plasticoding.py:205-236, which joined them inside the
// genotype: decision 1). Where none holds, the symbol has no successor and
// stays. Linear in the genotype; the copies are occurrences of eight bytes.

#include "runtime/develop/regulate.h"

#include <cassert>
#include <utility>

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

void Join(const Genotype& genotype, RuleIndex index, bool is_first,
          std::vector<Occurrence>& joined) {
  const Rule& rule = genotype.rules[index];
  for (std::size_t i = 0; i < rule.production.size(); ++i) {
    const Symbol& symbol = rule.production[i];
    if (!is_first && IsLeadingCore(genotype, rule.head, symbol, i)) continue;
    joined.push_back({symbol.id, index, static_cast<std::uint32_t>(i)});
  }
}

Successors JoinAll(const Genotype& genotype,
                   const std::vector<RuleIndex>& rules) {
  std::size_t length = 0;
  for (const RuleIndex index : rules)
    length += genotype.rules[index].production.size();
  std::vector<Occurrence> occurrences;
  occurrences.reserve(length);
  std::vector<std::uint32_t> begins;
  const std::size_t symbols = genotype.alphabet->symbols().size();
  begins.reserve(symbols + 1);
  for (const RuleIndex index : rules) {  // grouped by head, in alphabet order
    const auto head = static_cast<std::size_t>(genotype.rules[index].head);
    assert(begins.size() <= head + 1);
    const bool is_first = begins.size() <= head;
    if (is_first)
      begins.resize(head + 1, static_cast<std::uint32_t>(occurrences.size()));
    Join(genotype, index, is_first, occurrences);
  }
  begins.resize(symbols + 1, static_cast<std::uint32_t>(occurrences.size()));
  return {std::move(occurrences), std::move(begins)};
}

/// In order.
std::vector<RuleIndex> RulesThatHold(const Genotype& genotype,
                                     const Environment& environment) {
  std::vector<RuleIndex> rules;
  rules.reserve(genotype.rules.size());
  for (std::size_t i = 0; i < genotype.rules.size(); ++i)
    if (ClauseHolds(genotype.rules[i].clause, environment.values))
      rules.push_back(static_cast<RuleIndex>(i));
  return rules;
}

}  // namespace

Successors::Successors(std::vector<Occurrence> occurrences,
                       std::vector<std::uint32_t> begins)
    : occurrences_(std::move(occurrences)), begins_(std::move(begins)) {
  assert(!begins_.empty() && begins_.back() == occurrences_.size());
}

ActiveRules Regulate(const Genotype& genotype, const Environment& environment) {
  assert(environment.values.size() == genotype.states.size());
  assert(genotype.rules.size() < kNoRule);
  std::vector<RuleIndex> rules = RulesThatHold(genotype, environment);
  Successors joined = JoinAll(genotype, rules);
  return {std::move(rules), std::move(joined)};
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
