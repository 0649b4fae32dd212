// Derive with a memory: each symbol that was ever inserted is an Insertion, a
// string is a list of their numbers, and a symbol that is not rewritten keeps
// its number. Parents come before children and children of one parent are
// neighbours, so a first child and a count say all. It must rewrite exactly as
// Derive does; tests compare the strings.
//
// Memory is what it costs: 24 bytes a symbol inserted and four a symbol of each
// string, bounded by kMaxKeptSymbols.

#include "runtime/develop/derivation.h"

#include <span>
#include <utility>

namespace plsc {

namespace {

std::span<const Occurrence> Successor(const ActiveRules& active,
                                      const Insertion& insertion) {
  return active.joined[insertion.occurrence.symbol];
}

// The string after one more rewriting, its new symbols added to `derivation`;
// nothing when it would be too long.
std::optional<std::vector<InsertionId>> RewriteOnce(const ActiveRules& active,
                                                    int iteration,
                                                    Derivation& derivation) {
  std::vector<InsertionId> next;
  for (const InsertionId id : derivation.steps.back()) {
    const std::span<const Occurrence> successor =
        Successor(active, derivation.insertions[id]);
    if (next.size() + successor.size() + (successor.empty() ? 1 : 0) >
        kMaxStringLength)
      return std::nullopt;
    if (successor.empty()) {
      next.push_back(id);
      continue;
    }
    const auto first = static_cast<InsertionId>(derivation.insertions.size());
    derivation.insertions[id].first_child = first;
    derivation.insertions[id].child_count =
        static_cast<std::uint32_t>(successor.size());
    for (const Occurrence& occurrence : successor) {
      next.push_back(static_cast<InsertionId>(derivation.insertions.size()));
      derivation.insertions.push_back({occurrence, iteration, id});
    }
  }
  return next;
}

}  // namespace

std::optional<Derivation> DeriveWithHistory(const Genotype& genotype,
                                            const ActiveRules& active) {
  Derivation derivation;
  derivation.insertions.push_back({Occurrence{genotype.axiom, kNoRule, 0}});
  derivation.steps.push_back({0});
  std::size_t kept = 1;
  for (int i = 1; i <= genotype.development.iterations; ++i) {
    auto next = RewriteOnce(active, i, derivation);
    if (!next) return std::nullopt;
    kept += next->size();
    if (kept > kMaxKeptSymbols) return std::nullopt;
    derivation.steps.push_back(std::move(*next));
  }
  return derivation;
}

SymbolString FinalString(const Derivation& derivation) {
  SymbolString string;
  string.reserve(derivation.string().size());
  for (const InsertionId id : derivation.string())
    string.push_back(derivation[id].occurrence);
  return string;
}

std::vector<InsertionId> Ancestry(const Derivation& derivation,
                                  InsertionId id) {
  std::vector<InsertionId> ancestry;
  for (; id != kNoInsertion; id = derivation[id].parent) ancestry.push_back(id);
  return ancestry;
}

}  // namespace plsc
