// Rules of one symbol are inherited together, with their clauses (paper,
// "Crossover"; authors' program, standard_crossover.py:7-27): they were
// selected together, and a clause without its alternative would be another
// regulation. Genotype::rules is grouped by head in alphabet order, and going
// through the alphabet keeps it so.

#include "runtime/vary/crossover.h"

#include <cassert>

namespace plsc {

std::vector<bool> DrawCrossover(const Alphabet& alphabet, Rng& rng) {
  std::vector<bool> from_second;
  for (const SymbolInfo& symbol : alphabet.symbols())
    if (symbol.is_replaceable) from_second.push_back(rng.Bernoulli(0.5));
  return from_second;
}

Genotype Cross(const Genotype& first, const Genotype& second,
               const std::vector<bool>& from_second) {
  assert(*first.alphabet == *second.alphabet && first.states == second.states);
  Genotype child = first;
  child.name.clear();
  child.rules.clear();
  std::size_t choice = 0;
  const std::vector<SymbolInfo>& symbols = first.alphabet->symbols();
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    if (!symbols[i].is_replaceable) continue;
    assert(choice < from_second.size());
    const Genotype& parent = from_second[choice++] ? second : first;
    for (const Rule& rule : parent.rules)
      if (rule.head == static_cast<SymbolId>(i)) child.rules.push_back(rule);
  }
  return child;
}

}  // namespace plsc
