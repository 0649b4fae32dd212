#include "runtime/lsp/descriptions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "compiler/print.h"
#include "compiler/state_space.h"
#include "compiler/truth.h"
#include "grammar/number.h"

namespace plsc::lsp {

namespace {

std::string RangeText(const Parameter& parameter) {
  const bool has_low = std::isfinite(parameter.low);
  const bool has_high = std::isfinite(parameter.high);
  if (has_low && has_high)
    return fmt::format("{}..{}", PrintNumber(parameter.low),
                       PrintNumber(parameter.high));
  if (has_low) return fmt::format("{} or more", PrintNumber(parameter.low));
  return "";
}

std::string_view CategoryText(Category category) {
  switch (category) {
    case Category::kModule:
      return "module: rules may rewrite it";
    case Category::kMounting:
      return "mounting command";
    case Category::kMoving:
      return "moving command";
    case Category::kControllerMoving:
      return "controller-moving command";
    case Category::kControllerChanging:
      return "controller-changing command";
    case Category::kTerminal:
      return "terminal: no rule rewrites it";
  }
  return "";
}

std::string TypeText(const State& state) {
  switch (state.type) {
    case StateType::kBool:
      return "bool";
    case StateType::kReal:
      return fmt::format("real in {}..{}", PrintNumber(state.low),
                         PrintNumber(state.high));
    case StateType::kEnum:
      return fmt::format("{{ {} }}", fmt::join(state.values, ", "));
  }
  return "";
}

std::string TruthRow(const Clause& clause, const StateSpace& space, int index,
                     const std::vector<State>& states) {
  std::string row = "|";
  for (std::size_t s = 0; s < space.states().size(); ++s) {
    std::string label = ClassLabel(space.classes(s)[space.ClassAt(index, s)],
                                   StateAt(states, space.states()[s]));
    // A bar would end the cell.
    for (std::size_t at = 0; (at = label.find('|', at)) != std::string::npos;)
      label.replace(at, 1, ", ");
    row += fmt::format(" {} |", label);
  }
  return row +
         (ClauseHolds(clause, space.At(index)) ? " **yes** |\n" : " no |\n");
}

}  // namespace

std::string SignatureOf(const SymbolInfo& symbol) {
  if (symbol.parameters.empty()) return symbol.name;
  std::vector<std::string> parameters;
  for (const Parameter& parameter : symbol.parameters) {
    const std::string range = RangeText(parameter);
    parameters.push_back(range.empty()
                             ? parameter.name
                             : fmt::format("{} in {}", parameter.name, range));
  }
  return fmt::format("{}({})", symbol.name, fmt::join(parameters, ", "));
}

std::string DescribeParameter(const Parameter& parameter) {
  std::string text = fmt::format("`{}`", parameter.name);
  const std::string range = RangeText(parameter);
  if (!range.empty()) text += fmt::format(" in {}", range);
  if (parameter.is_integer) text += ", a whole number";
  if (!parameter.doc.empty()) text += fmt::format(": {}", parameter.doc);
  return text;
}

std::string DescribeSymbol(const SymbolInfo& symbol) {
  std::string text = fmt::format("```pls\n{}\n```\n", SignatureOf(symbol));
  if (!symbol.doc.empty()) text += fmt::format("{}\n\n", symbol.doc);
  text += fmt::format("*{}*\n", CategoryText(symbol.category));
  if (!symbol.parameters.empty()) text += '\n';
  for (const Parameter& parameter : symbol.parameters)
    text += fmt::format("- {}\n", DescribeParameter(parameter));
  return text;
}

std::string DescribeState(const State& state) {
  return fmt::format("```pls\nsense {}: {}\n```\n", state.name,
                     TypeText(state));
}

std::string DescribeEnvironment(const NamedEnvironment& environment,
                                const std::vector<State>& states) {
  return fmt::format("```pls\nenvironment {}\n```\n{}\n", environment.name,
                     PrintEnvironment(environment.environment, states));
}

std::string TruthMarkdown(const Clause& clause,
                          const std::vector<State>& states) {
  const std::array<const Clause*, 1> clauses = {&clause};
  const StateSpace space(clauses, states);
  if (!space.size())
    return fmt::format("The clause tells apart more than {} environments.\n",
                       StateSpace::kMaxCombinations);
  std::string text = "|";
  std::string rule = "|";
  for (const StateId id : space.states()) {
    text += fmt::format(" {} |", StateAt(states, id).name);
    rule += "---|";
  }
  text += " active |\n" + rule + "---|\n";
  const int shown = std::min(*space.size(), kMaxTruthRows);
  for (int i = 0; i < shown; ++i) text += TruthRow(clause, space, i, states);
  if (shown < *space.size())
    text +=
        fmt::format("\n... and {} environments more\n", *space.size() - shown);
  const TruthTable table = Tabulate(clause, space);
  text += fmt::format("\nActive in {} of {} environments.\n", table.Count(),
                      table.size());
  return text;
}

}  // namespace plsc::lsp
