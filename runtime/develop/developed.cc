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
    developed.string.push_back(SymbolAt(genotype, occurrence));
  }
  return developed;
}

Key DevelopedKey(const Genotype& genotype, const Developed& developed) {
  if (developed.robot) return RobotKey(*developed.robot);
  std::string text;
  for (const Symbol& symbol : developed.string)
    text += PrintSymbol(symbol, *genotype.alphabet) + '\n';
  return KeyOf(text);
}

Key RobotKey(const std::string& body, const std::string& brain) {
  return KeyOf(body + '\n' + brain);
}

Key RobotKey(const Phenotype& robot) {
  return RobotKey(BodyJson(robot.body), BrainJson(robot));
}

}  // namespace plsc
