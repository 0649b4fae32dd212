#include "runtime/pictures/drawn_robot.h"

#include <fmt/format.h>

#include "compiler/named_environments.h"
#include "compiler/print.h"

namespace plsc {

namespace {

std::vector<RuleIndex> MakersOf(const History& history) {
  std::vector<RuleIndex> rules;
  for (const StringIndex index : history.trace->module_origins) {
    const InsertionId id = history.derivation.string()[index];
    rules.push_back(history.derivation[id].occurrence.rule);
  }
  return rules;
}

}  // namespace

void DrawnRobot::Add(const NamedEnvironment& named, const History& history,
                     const std::vector<State>& states) {
  const std::string senses = SensesOf(named, states);
  const Phenotype& phenotype = history.trace->phenotype;
  bodies.push_back({named.name, senses, phenotype.body, MakersOf(history)});
  brains.push_back({named.name, senses, phenotype});
}

std::vector<std::string> RuleTexts(const Source& source,
                                   const MappedProgram& mapped) {
  const Genotype& genotype = mapped.program.genotype;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < genotype.rules.size(); ++i) {
    const Rule& rule = genotype.rules[i];
    const Span span = mapped.map.rules[i].rule;
    texts.push_back(fmt::format(
        "rule {}: {}, {} (line {})", i + 1, genotype.SymbolOf(rule.head).name,
        rule.clause.is_always() ? std::string("always")
                                : "if " + PrintClause(rule.clause, genotype),
        source.PositionOf(span.begin).line));
  }
  return texts;
}

}  // namespace plsc
