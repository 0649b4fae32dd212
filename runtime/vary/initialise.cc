#include "runtime/vary/initialise.h"

#include <cassert>

#include "runtime/vary/draw.h"

namespace plsc {

namespace {

/// Uniform in low to high.
std::size_t DrawBetween(int low, int high, Rng& rng) {
  assert(0 <= low && low <= high);
  return static_cast<std::size_t>(low) +
         rng.Index(static_cast<std::size_t>(high - low) + 1);
}

Clause DrawClause(const GenotypeOptions& options, Rng& rng) {
  Clause clause;
  if (options.encoding == Encoding::kBaseline) return clause;
  const std::size_t terms =
      DrawBetween(options.min_initial_terms,
                  options.max_initial_terms.value_or(options.max_terms), rng);
  for (std::size_t i = 0; i < terms; ++i) {
    if (i > 0) clause.connectives.push_back(DrawConnective(rng));
    clause.terms.push_back(DrawTerm(options.states, rng));
  }
  return clause;
}

std::vector<Symbol> DrawProduction(const Alphabet& alphabet, SymbolId head,
                                   std::size_t groups, Rng& rng) {
  using enum Category;
  std::vector<Symbol> production;
  if (head == plasticoding::kC) production.push_back({head, {}});
  for (std::size_t i = 0; i < groups; ++i)
    for (const Category category :
         {kControllerMoving, kControllerChanging, kMounting, kModule, kMoving})
      production.push_back(DrawSymbol(alphabet, category, rng));
  return production;
}

}  // namespace

Genotype Initialise(const GenotypeOptions& options, Rng& rng) {
  const bool is_plastic = options.encoding == Encoding::kPlasticoding;
  assert(options.min_groups >= 1);
  assert(!is_plastic || (!options.states.empty() && options.max_rules >= 1 &&
                         options.max_terms >= 1));
  Genotype genotype;
  genotype.axiom = plasticoding::kC;
  genotype.development = options.development;
  genotype.max_rules = is_plastic ? options.max_rules : 1;
  if (is_plastic) {
    genotype.states = options.states;
    genotype.max_terms = options.max_terms;
  }
  const auto draw_groups = [&] {
    return DrawBetween(options.min_groups, options.max_groups, rng);
  };
  std::size_t groups = draw_groups();
  const Alphabet& alphabet = *genotype.alphabet;
  for (const SymbolId head : alphabet.OfCategory(Category::kModule)) {
    for (int i = 0; i < *genotype.max_rules; ++i) {
      Rule rule;
      rule.head = head;
      rule.clause = DrawClause(options, rng);
      if (options.groups_per_rule) groups = draw_groups();
      rule.production = DrawProduction(alphabet, head, groups, rng);
      genotype.rules.push_back(std::move(rule));
    }
  }
  return genotype;
}

}  // namespace plsc
