#include "runtime/develop/developed.h"

#include <string>
#include <utility>

#include "compiler/print.h"
#include "runtime/develop/derive.h"
#include "runtime/develop/develop.h"
#include "runtime/develop/phenotype_json.h"

namespace plsc {

std::optional<Developed> DevelopActive(const Genotype& genotype,
                                       const ActiveRules& active) {
  const std::optional<SymbolString> string = Derive(genotype, active);
  if (!string) return std::nullopt;
  Developed developed;
  if (genotype.alphabet->is_built_in()) {
    developed.robot = Develop(genotype, *string);
    return developed;
  }
  for (const Occurrence& occurrence : *string) {
    Symbol symbol{occurrence.symbol, {}};
    if (occurrence.rule != kNoRule)
      symbol = genotype.rules[occurrence.rule].production[occurrence.position];
    developed.string.push_back(symbol);
  }
  return developed;
}

Key DevelopedKey(const Genotype& genotype, const Developed& developed) {
  if (developed.robot)
    return KeyOf(BodyJson(developed.robot->body) + '\n' +
                 BrainJson(*developed.robot));
  std::string text;
  for (const Symbol& symbol : developed.string)
    text += PrintSymbol(symbol, *genotype.alphabet) + '\n';
  return KeyOf(text);
}

}  // namespace plsc
