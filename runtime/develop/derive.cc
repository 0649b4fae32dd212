// An L-system without context, rewritten in parallel: each symbol of the string
// is replaced by what its active rules make of it, all at once, k times (paper,
// "Mapping stage 1"; authors' program, plasticoding.py:238-257). What a
// rewriting inserts is not looked at again by the same one. C is no exception:
// its productions begin with C, so it stays first, and every rewriting puts the
// rest of its production right behind it again.
//
// A string holds no arguments but occurrences, eight bytes each, that say where
// in the genotype a symbol is written. So rewriting is copying blocks of bytes,
// and whoever reads the string knows which rule brought each symbol.
//
// The length is counted before anything is written: an evolved genotype may ask
// for more than there is memory, and a string cut off in the middle would be a
// robot that no genotype describes, so beyond kMaxStringLength there is none.
// Time and memory are linear in the strings, of which the last is most; who
// only reads it need not have it written (DeriveAllButLast). How long a string
// would be that is too long is growth's to tell.

#include "runtime/develop/derive.h"

#include <cassert>
#include <span>
#include <utility>

namespace plsc {

namespace {

std::size_t LengthAfter(const SymbolString& string, const ActiveRules& active) {
  std::size_t length = 0;
  for (const Occurrence& occurrence : string) {
    length += RewrittenInto(active.joined, occurrence).size();
    if (length > kMaxStringLength) return length;
  }
  return length;
}

// One parallel rewriting; false when the result would be too long. `next` is
// reused between rewritings, so that a derivation allocates rarely. As its
// length is known, symbols are stored without asking for room each time.
bool Rewrite(const SymbolString& string, const ActiveRules& active,
             SymbolString& next) {
  const std::size_t length = LengthAfter(string, active);
  if (length > kMaxStringLength) return false;
  next.clear();
  next.resize(length);
  auto end = next.begin();
  for (const Occurrence& occurrence : string)
    for (const Occurrence& written : RewrittenInto(active.joined, occurrence))
      *end++ = written;
  assert(end == next.end());
  return true;
}

SymbolString Axiom(const Genotype& genotype) {
  return {Occurrence{genotype.axiom, kNoRule, 0}};
}

std::optional<SymbolString> DeriveTimes(const Genotype& genotype,
                                        const ActiveRules& active,
                                        int iterations) {
  SymbolString string = Axiom(genotype);
  SymbolString next;
  for (int i = 0; i < iterations; ++i) {
    if (!Rewrite(string, active, next)) return std::nullopt;
    std::swap(string, next);
  }
  return string;
}

}  // namespace

std::optional<SymbolString> Derive(const Genotype& genotype,
                                   const ActiveRules& active) {
  return DeriveTimes(genotype, active, genotype.development.iterations);
}

std::optional<SymbolString> DeriveAllButLast(const Genotype& genotype,
                                             const ActiveRules& active) {
  assert(genotype.development.iterations > 0);
  std::optional<SymbolString> string =
      DeriveTimes(genotype, active, genotype.development.iterations - 1);
  if (!string || LengthAfter(*string, active) > kMaxStringLength)
    return std::nullopt;
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
