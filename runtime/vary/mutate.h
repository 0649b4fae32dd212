#pragma once

// Mutation (paper, "Mutation"): one change of one rule. Arguments of existing
// symbols never change, C is neither added, deleted nor moved. Where the
// authors' program differs from what the paper says (it found symbols by value
// and never appended), an option chooses; docs/experiments.md compares them.

#include <optional>
#include <string_view>

#include "grammar/enum_names.h"
#include "runtime/vary/initialise.h"

namespace plsc {

enum class MutationKind : std::uint8_t { kDelete, kSwap, kAdd, kClause };

inline constexpr EnumNames<MutationKind, 4> kMutationNames{
    {{MutationKind::kDelete, "delete"},
     {MutationKind::kSwap, "swap"},
     {MutationKind::kAdd, "add"},
     {MutationKind::kClause, "clause"}}};

/// Where a symbol may be added; never before C.
enum class InsertionPoint : std::uint8_t {
  kAnywhere,   ///< the end included
  kBeforeEnd,  ///< before the last symbol or earlier, as the authors' program;
               ///< after C in a rule of C alone, where that program fails
};

/// Which symbol a position that was drawn for deletion or a swap means.
enum class Removal : std::uint8_t {
  kByPosition,
  kByValue,  ///< the first one equal to it, as in the authors' program
};

/// Defaults are the paper's.
struct MutationOptions {
  /// Share of clause changes among mutations, 0 to 1; the other kinds share
  /// the rest evenly. Not used for Encoding::kBaseline.
  double clause_share = 0.25;
  InsertionPoint insertion = InsertionPoint::kAnywhere;
  Removal removal = Removal::kByPosition;

  friend bool operator==(const MutationOptions&,
                         const MutationOptions&) = default;
};

/// What was tried on which rule (index into Genotype::rules). A deletion that
/// meets C or a rule of one symbol, and a swap with C or of a symbol with
/// itself, change nothing.
struct Mutation {
  MutationKind kind = MutationKind::kDelete;
  std::size_t rule = 0;

  friend bool operator==(const Mutation&, const Mutation&) = default;
};

/// The mutated rule as users count: from 1, as diagnostics, `plsc show` and all
/// JSON do. (Of the tables, only the store's column counts from 0.)
inline std::size_t RuleNumber(const Mutation& mutation) {
  return mutation.rule + 1;
}

/// A symbol with rules and one of its rules, each uniformly, and a kind
/// (kClause only in kPlasticoding). The genotype has at least one rule.
Mutation DrawMutation(const Genotype& genotype, Encoding encoding, Rng& rng,
                      const MutationOptions& options = {});

/// Applies it; where (and what is added) is drawn.
Genotype Mutate(Genotype genotype, const Mutation& mutation, Rng& rng,
                const MutationOptions& options = {});

/// The parts, for rules of any genotype:
Rule DeleteSymbol(Rule rule, Rng& rng, Removal removal = {});
/// Two positions, drawn independently.
Rule SwapSymbols(Rule rule, Rng& rng, Removal removal = {});
/// A symbol of a category drawn first, at a position from 0 (1 where C is
/// first) to where `insertion` ends, uniformly.
Rule AddSymbol(Rule rule, const Alphabet& alphabet, Rng& rng,
               InsertionPoint insertion = {});

/// One of the changes that are possible, each as likely: change a term (bool:
/// True becomes False and the reverse; enum: another comparison or value;
/// real: a fresh comparison and number), remove a term if there are two or
/// more, flip an operator if there is one, append a term if there are fewer
/// than `max_terms`. A clause without terms can only be given its first one;
/// without states nothing changes.
Clause ChangeClause(Clause clause, const std::vector<State>& states,
                    std::optional<int> max_terms, Rng& rng);

}  // namespace plsc
