#include "runtime/develop.h"

#include <cassert>
#include <utility>

#include "runtime/string_reader.h"

namespace plsc {

Phenotype Develop(const Genotype& genotype, const SymbolString& string) {
  assert(genotype.alphabet->is_built_in());
  assert(!string.empty() && string.front().symbol == plasticoding::kC);
  StringReader reader(genotype.development);
  for (const Occurrence& occurrence : string)
    reader.Read(occurrence.symbol, ArgumentsOf(genotype, occurrence));
  return std::move(reader).Take();
}

std::optional<Phenotype> Develop(const Genotype& genotype,
                                 const Environment& environment) {
  const std::optional<SymbolString> string =
      Derive(genotype, Regulate(genotype, environment));
  if (!string) return std::nullopt;
  return Develop(genotype, *string);
}

}  // namespace plsc
