#include "tests/runtime/merge/mutation_pair.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace plsc::test {

namespace {

using Symbols = std::vector<Symbol>;
using Index = std::ptrdiff_t;

// What a mutation did to the elements of a list.
struct Step {
  enum class Kind { kDelete, kInsert, kSwap, kMove } kind{};
  Index at = 0;    // of kInsert: before which element
  Index with = 0;  // of kSwap; of kMove: the place in what is left
  Symbol symbol{};
};

Symbols Apply(Symbols symbols, const Step& step) {
  switch (step.kind) {
    case Step::Kind::kDelete:
      symbols.erase(symbols.begin() + step.at);
      break;
    case Step::Kind::kInsert:
      symbols.insert(symbols.begin() + step.at, step.symbol);
      break;
    case Step::Kind::kSwap:
      std::swap(symbols[static_cast<std::size_t>(step.at)],
                symbols[static_cast<std::size_t>(step.with)]);
      break;
    case Step::Kind::kMove: {
      const Symbol moved = symbols[static_cast<std::size_t>(step.at)];
      symbols.erase(symbols.begin() + step.at);
      symbols.insert(symbols.begin() + step.with, moved);
      break;
    }
  }
  return symbols;
}

// All steps that explain the change; several where neighbours are equal.
std::vector<Step> StepsBetween(const Symbols& from, const Symbols& to) {
  std::vector<Step> candidates;
  const auto size = static_cast<Index>(from.size());
  for (Index i = 0; i <= size; ++i) {
    if (to.size() > from.size())
      candidates.push_back(
          {Step::Kind::kInsert, i, 0, to[static_cast<std::size_t>(i)]});
    else if (to.size() < from.size() && i < size)
      candidates.push_back({Step::Kind::kDelete, i, 0, {}});
    for (Index j = i + 1; j < size && to.size() == from.size(); ++j)
      candidates.push_back({Step::Kind::kSwap, i, j, {}});
  }
  std::erase_if(candidates,
                [&](const Step& step) { return Apply(from, step) != to; });
  return candidates;
}

// Where an element is after `done`; nothing if that touched it.
std::optional<Index> ElementAfter(Index at, const Step& done) {
  switch (done.kind) {
    case Step::Kind::kDelete:
      if (at == done.at) return std::nullopt;
      return at > done.at ? at - 1 : at;
    case Step::Kind::kInsert:
      return at >= done.at ? at + 1 : at;
    case Step::Kind::kSwap:
      if (at == done.at) return done.with;
      if (at == done.with) return done.at;
      return at;
    case Step::Kind::kMove:
      break;
  }
  return std::nullopt;
}

// Where a gap is; nothing if `done` filled it.
std::optional<Index> GapAfter(Index at, const Step& done) {
  switch (done.kind) {
    case Step::Kind::kDelete:
      return at > done.at ? at - 1 : at;
    case Step::Kind::kInsert:
      if (at == done.at) return std::nullopt;
      return at > done.at ? at + 1 : at;
    case Step::Kind::kSwap:
      return at;
    case Step::Kind::kMove:
      break;
  }
  return std::nullopt;
}

// Two swaps of one element do not go together; of a swap with an element that
// was deleted, the other one still moves to where that was.
std::optional<Step> SwapAfter(const Step& step, const Step& done) {
  const auto is_of_swap = [&](Index at) {
    return at == step.at || at == step.with;
  };
  if (done.kind == Step::Kind::kSwap &&
      (is_of_swap(done.at) || is_of_swap(done.with)))
    return std::nullopt;
  if (done.kind == Step::Kind::kDelete && is_of_swap(done.at)) {
    const Index left = done.at == step.at ? step.with : step.at;
    if (left > done.at) return Step{Step::Kind::kMove, left - 1, done.at, {}};
    return Step{Step::Kind::kMove, left, done.at - 1, {}};
  }
  return Step{Step::Kind::kSwap,
              *ElementAfter(step.at, done),
              *ElementAfter(step.with, done),
              {}};
}

std::optional<Step> After(Step step, const Step& done) {
  if (step.kind == Step::Kind::kSwap) return SwapAfter(step, done);
  const auto at = step.kind == Step::Kind::kInsert
                      ? GapAfter(step.at, done)
                      : ElementAfter(step.at, done);
  if (!at) return std::nullopt;
  step.at = *at;
  return step;
}

// Every order and every reading of the steps gives the same.
std::optional<Symbols> Compose(const Symbols& base, const Symbols& ours,
                               const Symbols& theirs) {
  if (ours == base || ours == theirs) return theirs;
  if (theirs == base) return ours;
  std::optional<Symbols> result;
  for (const Step& a : StepsBetween(base, ours)) {
    for (const Step& b : StepsBetween(base, theirs)) {
      for (const auto& [first, second] : {std::pair{a, b}, std::pair{b, a}}) {
        const auto moved = After(second, first);
        if (!moved) return std::nullopt;
        Symbols both = Apply(Apply(base, first), *moved);
        if (result && *result != both) return std::nullopt;
        result = std::move(both);
      }
    }
  }
  return result;
}

// A change of a clause, as ChangeClause makes them.
struct ClauseStep {
  enum class Kind { kTerm, kConnective, kRemove, kAppend } kind{};
  std::size_t at = 0;
};

Clause WithoutTerm(Clause clause, std::size_t at) {
  clause.terms.erase(clause.terms.begin() + static_cast<Index>(at));
  if (!clause.connectives.empty())
    clause.connectives.erase(clause.connectives.begin() +
                             static_cast<Index>(at == 0 ? 0 : at - 1));
  return clause;
}

std::vector<ClauseStep> ClauseStepsBetween(const Clause& from,
                                           const Clause& to) {
  using Kind = ClauseStep::Kind;
  std::vector<ClauseStep> steps;
  if (to.terms.size() > from.terms.size())
    steps.push_back({Kind::kAppend, from.terms.size()});
  for (std::size_t i = 0; i < from.terms.size(); ++i) {
    if (to.terms.size() < from.terms.size()) {
      if (WithoutTerm(from, i) == to) steps.push_back({Kind::kRemove, i});
    } else if (to.terms[i] != from.terms[i]) {
      steps.push_back({Kind::kTerm, i});
    }
  }
  if (to.terms.size() == from.terms.size())
    for (std::size_t i = 0; i < from.connectives.size(); ++i)
      if (to.connectives[i] != from.connectives[i])
        steps.push_back({Kind::kConnective, i});
  return steps;
}

// `b`, which made `to` of the base, done to `clause`, which `a` made of it.
std::optional<Clause> DoAfter(const ClauseStep& a, Clause clause,
                              const ClauseStep& b, const Clause& to) {
  using Kind = ClauseStep::Kind;
  const bool is_removed = a.kind == Kind::kRemove;
  switch (b.kind) {
    case Kind::kTerm: {
      if ((is_removed || a.kind == Kind::kTerm) && a.at == b.at)
        return std::nullopt;
      const std::size_t at = is_removed && b.at > a.at ? b.at - 1 : b.at;
      clause.terms[at] = to.terms[b.at];
      return clause;
    }
    case Kind::kConnective:
      // A term goes with its connective, and here there are two at most.
      if (is_removed || (a.kind == Kind::kConnective && a.at == b.at))
        return std::nullopt;
      clause.connectives[b.at] = to.connectives[b.at];
      return clause;
    case Kind::kRemove:
      if (a.kind == Kind::kConnective || is_removed) return std::nullopt;
      if (a.kind == Kind::kTerm && a.at == b.at) return std::nullopt;
      return WithoutTerm(std::move(clause), b.at);
    case Kind::kAppend:
      if (a.kind == Kind::kAppend) return std::nullopt;
      clause.terms.push_back(to.terms.back());
      if (clause.terms.size() > 1) {
        if (to.connectives.empty()) return std::nullopt;
        clause.connectives.push_back(to.connectives.back());
      }
      return clause;
  }
  return std::nullopt;
}

std::optional<Clause> ComposeClauses(const Clause& base, const Clause& ours,
                                     const Clause& theirs) {
  if (ours == base || ours == theirs) return theirs;
  if (theirs == base) return ours;
  std::optional<Clause> result;
  for (const ClauseStep& a : ClauseStepsBetween(base, ours)) {
    for (const ClauseStep& b : ClauseStepsBetween(base, theirs)) {
      const auto one = DoAfter(a, ours, b, theirs);
      const auto other = DoAfter(b, theirs, a, ours);
      if (!one || !other || *one != *other) return std::nullopt;
      if (result && *result != *one) return std::nullopt;
      result = *one;
    }
  }
  return result;
}

std::optional<Genotype> Compose(const Genotype& base, const Genotype& ours,
                                const Genotype& theirs) {
  Genotype composed = base;
  for (std::size_t i = 0; i < base.rules.size(); ++i) {
    const auto clause = ComposeClauses(
        base.rules[i].clause, ours.rules[i].clause, theirs.rules[i].clause);
    const auto production =
        Compose(base.rules[i].production, ours.rules[i].production,
                theirs.rules[i].production);
    if (!clause || !production) return std::nullopt;
    composed.rules[i].clause = *clause;
    composed.rules[i].production = *production;
  }
  return composed;
}

// Draws until something changes: what changes nothing merges with anything.
Genotype Mutated(const Genotype& base, Rng rng, Mutation* mutation) {
  for (;;) {
    *mutation = DrawMutation(base, Encoding::kPlasticoding, rng);
    Genotype mutant = Mutate(base, *mutation, rng);
    if (mutant != base) return mutant;
  }
}

}  // namespace

MutationPair DrawMutationPair(std::uint64_t number) {
  GenotypeOptions options;
  if (number % 4 == 3)
    options.states.push_back({"hot", StateType::kBool, 0, 0, {}});
  if (number % 12 == 3)
    options.states.push_back({"height", StateType::kReal, -1, 5, {}});
  Rng rng({number, 0, 0, Purpose::kInitialise});
  MutationPair pair;
  pair.base = Initialise(options, rng);
  pair.base.name = "individual_" + std::to_string(number);
  pair.ours = Mutated(pair.base, Rng({number, 1, 1, Purpose::kMutate}),
                      &pair.our_mutation);
  pair.theirs = Mutated(pair.base, Rng({number, 1, 2, Purpose::kMutate}),
                        &pair.their_mutation);
  pair.composed = Compose(pair.base, pair.ours, pair.theirs);
  return pair;
}

}  // namespace plsc::test
