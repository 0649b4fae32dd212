#include "runtime/develop/develop.h"

#include <cassert>
#include <cstdint>
#include <utility>
#include <vector>

#include "runtime/develop/string_reader.h"

namespace plsc {

namespace {

// Rewrites `string` once more and reads the result, which is never written: it
// would be most of what a development writes.
Phenotype ReadRewritten(const Genotype& genotype, const SymbolString& string,
                        const Successors& joined) {
  StringReader reader(genotype.development);
  for (const Occurrence& rewritten : string)
    for (const Occurrence& occurrence : RewrittenInto(joined, rewritten))
      reader.Read(occurrence.symbol, ArgumentsOf(genotype, occurrence));
  return std::move(reader).Take();
}

}  // namespace

Phenotype Develop(const Genotype& genotype, const SymbolString& string) {
  assert(genotype.alphabet->is_built_in());
  assert(!string.empty() && string.front().symbol == plasticoding::kC);
  const Successors none({}, std::vector<std::uint32_t>(
                                genotype.alphabet->symbols().size() + 1, 0));
  return ReadRewritten(genotype, string, none);
}

std::optional<Phenotype> Develop(const Genotype& genotype,
                                 const Environment& environment) {
  assert(genotype.alphabet->is_built_in());
  assert(genotype.axiom == plasticoding::kC);
  const ActiveRules active = Regulate(genotype, environment);
  if (genotype.development.iterations == 0)
    return Develop(genotype, *Derive(genotype, active));
  const std::optional<SymbolString> string = DeriveAllButLast(genotype, active);
  if (!string) return std::nullopt;
  return ReadRewritten(genotype, *string, active.joined);
}

}  // namespace plsc
