#include "runtime/history/regulation_text.h"

#include <fmt/format.h>

#include <vector>

#include "compiler/print.h"
#include "runtime/develop/part_names.h"
#include "runtime/develop/regulate.h"
#include "runtime/text/aligned_rows.h"

namespace plsc {

namespace {

using Row = std::vector<std::string>;

std::string RuleNumbers(const std::vector<RuleIndex>& rules) {
  if (rules.empty()) return "-";
  std::string text;
  for (const RuleIndex rule : rules)
    text += fmt::format("{}{}", text.empty() ? "" : "+", rule + 1);
  return text;
}

std::string JoinedText(const Genotype& genotype, const ActiveRules& active,
                       SymbolId symbol) {
  const auto joined = active.joined[symbol];
  if (joined.empty()) return "stays";
  std::string text = "->";
  for (const Occurrence& o : joined) text += ' ' + SymbolText(genotype, o);
  return text;
}

}  // namespace

std::string RegulationText(const Genotype& genotype,
                           const NamedEnvironment& named) {
  const ActiveRules active = Regulate(genotype, named.environment);
  const std::string senses =
      PrintEnvironment(named.environment, genotype.states);
  std::string text = fmt::format("{} in {}", genotype.name, named.name);
  if (!senses.empty() && senses != named.name)
    text += fmt::format(" ({})", senses);
  text += fmt::format(": {} of {} rules active\n", active.rules.size(),
                      genotype.rules.size());
  std::vector<Row> rows;
  for (const SymbolRules& symbol : BySymbol(genotype, active))
    rows.push_back({genotype.SymbolOf(symbol.symbol).name,
                    RuleNumbers(symbol.active),
                    JoinedText(genotype, active, symbol.symbol)});
  return rows.empty() ? text : text + AlignedRows(rows);
}

std::string RegulationTable(const Genotype& genotype, const StateSpace& space) {
  std::vector<Row> rows(1);
  for (const StateId id : space.states())
    rows[0].push_back(genotype.StateOf(id).name);
  for (const SymbolRules& symbol : BySymbol(genotype, {}))
    rows[0].push_back(genotype.SymbolOf(symbol.symbol).name);
  if (rows[0].empty()) return "no rules\n";
  for (int i = 0; i < *space.size(); ++i) {
    Row row;
    for (std::size_t s = 0; s < space.states().size(); ++s)
      row.push_back(ClassLabel(space.classes(s)[space.ClassAt(i, s)],
                               genotype.StateOf(space.states()[s])));
    const ActiveRules active = Regulate(genotype, {space.At(i)});
    for (const SymbolRules& symbol : BySymbol(genotype, active))
      row.push_back(RuleNumbers(symbol.active));
    rows.push_back(std::move(row));
  }
  return AlignedRows(rows);
}

std::string RuleLegend(const MappedProgram& compiled, const Source& source) {
  const Genotype& genotype = compiled.program.genotype;
  std::string text;
  for (std::size_t i = 0; i < genotype.rules.size(); ++i) {
    const Rule& rule = genotype.rules[i];
    const std::string clause = rule.clause.is_always()
                                   ? "always"
                                   : "if " + PrintClause(rule.clause, genotype);
    text += fmt::format(
        "{}: {} {} (line {})\n", i + 1, genotype.SymbolOf(rule.head).name,
        clause, source.PositionOf(compiled.map.rules[i].rule.begin).line);
  }
  return text;
}

}  // namespace plsc
