// One change of one rule (paper, "Mutation"; authors' program,
// standard_mutation.py): first which kind, then which symbol and which of its
// rules, then where. Arguments of existing symbols never change: new ones come
// with added symbols only, which is the paper's choice.
//
// What no mutation may do is make a genotype that Verify refuses. C stays first
// in its rules and occurs nowhere else, so it is neither deleted, swapped nor
// preceded; a rule keeps a symbol at least; a clause keeps one operator between
// two terms and its limit of terms. A draw that meets such a bar changes
// nothing instead of being drawn again: to draw again would raise the chances
// of all the rest, and samples of the authors' program would no longer fit.
//
// The order of draws and how many numbers each takes are part of every result,
// as streams are named by individual and not by draw: an added draw changes all
// that follow in that child, and with it all runs with that seed.

#include "runtime/vary/mutate.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

#include "runtime/vary/draw.h"

namespace plsc {

namespace {

using Offset = std::vector<Symbol>::difference_type;

bool IsCore(const Symbol& symbol) {
  return symbol.id == plasticoding::kC;
}

/// Heads that have rules, and of each the indices of its rules.
std::vector<std::vector<std::size_t>> RulesByHead(const Genotype& genotype) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < genotype.rules.size(); ++i) {
    if (i == 0 || genotype.rules[i].head != genotype.rules[i - 1].head)
      groups.emplace_back();
    groups.back().push_back(i);
  }
  return groups;
}

Comparison Opposite(Comparison comparison) {
  return comparison == Comparison::kEqual ? Comparison::kNotEqual
                                          : Comparison::kEqual;
}

/// Uniform among the 2n - 1 other pairs of comparison and value.
Term ChangeEnumTerm(Term term, std::size_t values, Rng& rng) {
  const auto current = static_cast<std::size_t>(term.value);
  const std::size_t step = 1 + rng.Index(2 * values - 1);
  const std::size_t place = current + step;  // current to current + 2n - 1
  if (place / values % 2 == 1) term.comparison = Opposite(term.comparison);
  term.value = static_cast<double>(place % values);
  return term;
}

Term ChangeTerm(const Term& term, const std::vector<State>& states, Rng& rng) {
  const State& state = StateAt(states, term.state);
  Term changed = term;
  switch (state.type) {
    case StateType::kBool:
      changed.value = 1 - term.value;
      return changed;
    case StateType::kEnum:
      return ChangeEnumTerm(term, state.values.size(), rng);
    case StateType::kReal:
      return DrawComparison(states, term.state, rng);
  }
  assert(false);
  return term;
}

enum class ClauseChange : std::uint8_t { kTerm, kRemove, kOperator, kAppend };

std::vector<ClauseChange> PossibleChanges(const Clause& clause,
                                          const std::vector<State>& states,
                                          std::optional<int> max_terms) {
  std::vector<ClauseChange> changes;
  if (!clause.terms.empty()) changes.push_back(ClauseChange::kTerm);
  if (clause.terms.size() > 1) {
    changes.push_back(ClauseChange::kRemove);
    changes.push_back(ClauseChange::kOperator);
  }
  const bool has_room =
      !max_terms || clause.terms.size() < static_cast<std::size_t>(*max_terms);
  if (has_room && !states.empty()) changes.push_back(ClauseChange::kAppend);
  return changes;
}

/// With the operator after the first term, else with the one before it.
Clause RemoveTerm(Clause clause, Rng& rng) {
  const std::size_t term = rng.Index(clause.terms.size());
  const std::size_t connective = term == 0 ? 0 : term - 1;
  clause.terms.erase(clause.terms.begin() + static_cast<Offset>(term));
  clause.connectives.erase(clause.connectives.begin() +
                           static_cast<Offset>(connective));
  return clause;
}

/// By Walker's alias method: each kind owns a quarter, and gives up what is
/// above its share. So the paper's even shares take one number, as they did
/// before shares could be chosen.
MutationKind DrawPlasticKind(double clause_share, Rng& rng) {
  const auto kind = static_cast<MutationKind>(rng.Index(4));
  const double others_share = (1 - clause_share) / 3;
  if (kind == MutationKind::kClause) {
    if (clause_share >= 0.25 || rng.Bernoulli(4 * clause_share)) return kind;
    return static_cast<MutationKind>(rng.Index(3));
  }
  if (clause_share <= 0.25 || rng.Bernoulli(4 * others_share)) return kind;
  return MutationKind::kClause;
}

/// The place of the symbol that `index` means.
std::size_t Meant(const std::vector<Symbol>& production, std::size_t index,
                  Removal removal) {
  if (removal == Removal::kByPosition) return index;
  const auto first =
      std::find(production.begin(), production.end(), production[index]);
  return static_cast<std::size_t>(first - production.begin());
}

}  // namespace

Mutation DrawMutation(const Genotype& genotype, Encoding encoding, Rng& rng,
                      const MutationOptions& options) {
  assert(!genotype.rules.empty());
  Mutation mutation;
  mutation.kind = encoding == Encoding::kPlasticoding
                      ? DrawPlasticKind(options.clause_share, rng)
                      : static_cast<MutationKind>(rng.Index(3));
  const auto groups = RulesByHead(genotype);
  const std::vector<std::size_t>& group = groups[rng.Index(groups.size())];
  mutation.rule = group[rng.Index(group.size())];
  return mutation;
}

Genotype Mutate(Genotype genotype, const Mutation& mutation, Rng& rng,
                const MutationOptions& options) {
  Rule& rule = genotype.rules[mutation.rule];
  switch (mutation.kind) {
    case MutationKind::kDelete:
      rule = DeleteSymbol(std::move(rule), rng, options.removal);
      break;
    case MutationKind::kSwap:
      rule = SwapSymbols(std::move(rule), rng, options.removal);
      break;
    case MutationKind::kAdd:
      rule = AddSymbol(std::move(rule), *genotype.alphabet, rng,
                       options.insertion);
      break;
    case MutationKind::kClause:
      rule.clause = ChangeClause(std::move(rule.clause), genotype.states,
                                 genotype.max_terms, rng);
      break;
  }
  return genotype;
}

Rule DeleteSymbol(Rule rule, Rng& rng, Removal removal) {
  std::vector<Symbol>& production = rule.production;
  if (production.size() < 2) return rule;
  const std::size_t index =
      Meant(production, rng.Index(production.size()), removal);
  if (!IsCore(production[index]))
    production.erase(production.begin() + static_cast<Offset>(index));
  return rule;
}

Rule SwapSymbols(Rule rule, Rng& rng, Removal removal) {
  std::vector<Symbol>& production = rule.production;
  if (production.size() < 2) return rule;
  const std::size_t first = rng.Index(production.size());
  const std::size_t second = rng.Index(production.size());
  Symbol& a = production[Meant(production, first, removal)];
  Symbol& b = production[Meant(production, second, removal)];
  if (!IsCore(a) && !IsCore(b)) std::swap(a, b);
  return rule;
}

Rule AddSymbol(Rule rule, const Alphabet& alphabet, Rng& rng,
               InsertionPoint insertion) {
  using enum Category;
  constexpr Category kCategories[] = {kModule, kMounting, kMoving,
                                      kControllerMoving, kControllerChanging};
  const Category category = kCategories[rng.Index(std::size(kCategories))];
  const Symbol symbol = DrawSymbol(alphabet, category, rng);
  std::vector<Symbol>& production = rule.production;
  const std::size_t first = IsCore(production.front()) ? 1 : 0;
  // Places from `first` on: one more than symbols from there on, or as many.
  std::size_t places = production.size() + 1 - first;
  if (insertion == InsertionPoint::kBeforeEnd && places > 1) --places;
  const std::size_t index = first + rng.Index(places);
  production.insert(production.begin() + static_cast<Offset>(index), symbol);
  return rule;
}

Clause ChangeClause(Clause clause, const std::vector<State>& states,
                    std::optional<int> max_terms, Rng& rng) {
  const auto changes = PossibleChanges(clause, states, max_terms);
  if (changes.empty()) return clause;
  switch (changes[rng.Index(changes.size())]) {
    case ClauseChange::kTerm: {
      Term& term = clause.terms[rng.Index(clause.terms.size())];
      term = ChangeTerm(term, states, rng);
      return clause;
    }
    case ClauseChange::kRemove:
      return RemoveTerm(std::move(clause), rng);
    case ClauseChange::kOperator: {
      Connective& flipped =
          clause.connectives[rng.Index(clause.connectives.size())];
      flipped =
          flipped == Connective::kAnd ? Connective::kOr : Connective::kAnd;
      return clause;
    }
    case ClauseChange::kAppend:
      if (!clause.terms.empty())
        clause.connectives.push_back(DrawConnective(rng));
      clause.terms.push_back(DrawTerm(states, rng));
      return clause;
  }
  assert(false);
  return clause;
}

}  // namespace plsc
