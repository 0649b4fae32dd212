#include "runtime/derive.h"

#include <span>
#include <utility>

namespace plsc {

namespace {

std::span<const Occurrence> Successor(const ActiveRules& active,
                                         const Occurrence& occurrence) {
  return active.joined[static_cast<std::size_t>(occurrence.symbol)];
}

std::size_t LengthAfter(const SymbolString& string, const ActiveRules& active) {
  std::size_t length = 0;
  for (const Occurrence& occurrence : string) {
    const std::size_t successor = Successor(active, occurrence).size();
    length += successor == 0 ? 1 : successor;
    if (length > kMaxStringLength) return length;
  }
  return length;
}

// One parallel rewriting; false when the result would be too long. `next` is
// reused between rewritings, so that a derivation allocates rarely.
bool Rewrite(const SymbolString& string, const ActiveRules& active,
             SymbolString& next) {
  const std::size_t length = LengthAfter(string, active);
  if (length > kMaxStringLength) return false;
  next.clear();
  next.reserve(length);
  for (const Occurrence& occurrence : string) {
    const std::span<const Occurrence> successor = Successor(active, occurrence);
    if (successor.empty())
      next.push_back(occurrence);
    else
      next.insert(next.end(), successor.begin(), successor.end());
  }
  return true;
}

SymbolString Axiom(const Genotype& genotype) {
  return {Occurrence{genotype.axiom, kNoRule, 0}};
}

}  // namespace

std::optional<SymbolString> Derive(const Genotype& genotype,
                                   const ActiveRules& active) {
  SymbolString string = Axiom(genotype);
  SymbolString next;
  for (int i = 0; i < genotype.development.iterations; ++i) {
    if (!Rewrite(string, active, next)) return std::nullopt;
    std::swap(string, next);
  }
  return string;
}

std::optional<std::vector<SymbolString>> DeriveSteps(
    const Genotype& genotype, const ActiveRules& active) {
  std::vector<SymbolString> steps{Axiom(genotype)};
  for (int i = 0; i < genotype.development.iterations; ++i) {
    SymbolString next;
    if (!Rewrite(steps.back(), active, next)) return std::nullopt;
    steps.push_back(std::move(next));
  }
  return steps;
}

}  // namespace plsc
