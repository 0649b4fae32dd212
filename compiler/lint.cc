#include "compiler/lint.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>

#include "compiler/print.h"
#include "compiler/truth.h"
#include "grammar/parse.h"

namespace plsc {

namespace {

struct Gap {
  std::string where;  // `inclined = True and hot = True`: the first one
  int count = 0;
  int total = 0;
};

// The environment that `values` is, as a clause, of the states asked about.
std::string DescribeValues(const std::vector<StateId>& asked,
                           const std::vector<double>& values,
                           const Genotype& genotype) {
  Clause clause;
  for (const StateId id : asked) {
    Term term;
    term.state = id;
    term.value = values[static_cast<std::size_t>(id)];
    if (!clause.terms.empty()) clause.connectives.push_back(Connective::kAnd);
    clause.terms.push_back(term);
  }
  return PrintClause(clause, genotype);
}

std::optional<Gap> FindGap(std::span<const Rule> rules,
                           const Genotype& genotype) {
  std::vector<const Clause*> clauses;
  for (const Rule& rule : rules) clauses.push_back(&rule.clause);
  const StateSpace space(clauses, genotype.states);
  if (!space.size()) return std::nullopt;
  Gap gap;
  gap.total = *space.size();
  for (int i = 0; i < gap.total; ++i) {
    const std::vector<double> values = space.At(i);
    const bool is_covered = std::any_of(
        rules.begin(), rules.end(),
        [&](const Rule& rule) { return ClauseHolds(rule.clause, values); });
    if (is_covered) continue;
    if (gap.count++ == 0)
      gap.where = DescribeValues(space.states(), values, genotype);
  }
  if (gap.count == 0) return std::nullopt;
  return gap;
}

// Where the file's first rule for `head` names it.
Span FirstHead(const ast::File& file, const std::string& head) {
  for (const ast::Rule& rule : file.rules)
    if (file.Text(rule.head) == head) return rule.head;
  return {};
}

Diagnostic GapWarning(const std::string& head, Span span, const Gap& gap) {
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.code = "W3003";
  warning.span = span;
  warning.message =
      fmt::format("no rule for '{}' is active when {}", head, gap.where);
  warning.label = fmt::format("{} stays as it is in {} of {} environments",
                              head, gap.count, gap.total);
  return warning;
}

}  // namespace

std::vector<Diagnostic> Lint(const Program& program, const Source& source) {
  const ParseResult parsed = Parse(source);
  const Genotype& genotype = program.genotype;
  std::vector<Diagnostic> warnings;
  const std::span<const Rule> rules = genotype.rules;
  for (std::size_t begin = 0; begin < rules.size();) {
    std::size_t end = begin + 1;
    while (end < rules.size() && rules[end].head == rules[begin].head) ++end;
    const std::string& head = (*genotype.alphabet)[rules[begin].head].name;
    if (const auto gap = FindGap(rules.subspan(begin, end - begin), genotype))
      warnings.push_back(GapWarning(head, FirstHead(parsed.file, head), *gap));
    begin = end;
  }
  return warnings;
}

}  // namespace plsc
