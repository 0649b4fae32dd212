#pragma once

// Mutation (paper, "Mutation"): one change of one rule, by index. Arguments of
// existing symbols never change, C is neither added, deleted nor moved.
// Differences from the authors' program, which found symbols by value and
// never appended, are in docs/experiments.md.

#include <optional>
#include <string_view>

#include "runtime/evolve/initialise.h"

namespace plsc {

enum class MutationKind : std::uint8_t { kDelete, kSwap, kAdd, kClause };

/// "delete", "swap", "add", "clause", as logs name it.
std::string_view MutationName(MutationKind kind);

/// What was tried on which rule (index into Genotype::rules). A deletion that
/// meets C or a rule of one symbol, and a swap with C or of a symbol with
/// itself, change nothing.
struct Mutation {
  MutationKind kind = MutationKind::kDelete;
  std::size_t rule = 0;

  friend bool operator==(const Mutation&, const Mutation&) = default;
};

/// A symbol with rules, one of its rules, and a kind (kClause only in
/// kPlasticoding), each uniformly. The genotype has at least one rule.
Mutation DrawMutation(const Genotype& genotype, Encoding encoding, Rng& rng);

/// Applies it; where (and what is added) is drawn.
Genotype Mutate(Genotype genotype, const Mutation& mutation, Rng& rng);

/// The parts, for rules of any genotype:
Rule DeleteSymbol(Rule rule, Rng& rng);
/// Two positions, drawn independently.
Rule SwapSymbols(Rule rule, Rng& rng);
/// A symbol of a category drawn first, at a position from 0 (1 where C is
/// first) to the end.
Rule AddSymbol(Rule rule, const Alphabet& alphabet, Rng& rng);

/// One of the changes that are possible, each as likely: change a term (bool:
/// True becomes False and the reverse; enum: another comparison or value;
/// real: a fresh comparison and number), remove a term if there are two or
/// more, flip an operator if there is one, append a term if there are fewer
/// than `max_terms`. A clause without terms can only be given its first one;
/// without states nothing changes.
Clause ChangeClause(Clause clause, const std::vector<State>& states,
                    std::optional<int> max_terms, Rng& rng);

}  // namespace plsc
