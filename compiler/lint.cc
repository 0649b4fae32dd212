// Gaps and joins of the rules of one symbol, by set algebra over truth tables.
// `any` collects where some rule so far is active; what a further rule shares
// with it is where several are, and its complement at the end is where none is.
// One pass, a table a rule, rules times rows / 64 operations.
//
// Examples in messages are the first environment of a set, and the space counts
// in a fixed order, so the same file gives the same words.

#include "compiler/lint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "compiler/truth.h"
#include "grammar/reporter.h"

namespace plsc {

namespace {

// The rules of one symbol and where they were written.
struct Group {
  std::string head;
  std::span<const Rule> rules;
  std::span<const RuleSpans> written;
};

// In which environments none, and in which several of the rules are active.
struct Coverage {
  TruthTable none;
  TruthTable several;
  bool has_constant = false;  // some rule is active everywhere
};

Coverage Cover(std::span<const Rule> rules, const StateSpace& space) {
  const int size = *space.size();
  Coverage coverage{TruthTable(size, false), TruthTable(size, false)};
  TruthTable& any = coverage.none;
  for (const Rule& rule : rules) {
    const TruthTable table = Tabulate(rule.clause, space);
    TruthTable again = table;
    again &= any;
    coverage.several |= again;
    any |= table;
    coverage.has_constant |= table.Count() == size;
  }
  coverage.none.Invert();
  return coverage;
}

std::optional<Diagnostic> GapWarning(const Group& group, const TruthTable& none,
                                     const StateSpace& space,
                                     const std::vector<State>& states) {
  const std::optional<int> first = none.First();
  if (!first) return std::nullopt;
  return Diagnostic(Code::kNoActiveRule, group.written[0].head,
                    fmt::format("no rule for '{}' is active when {}",
                                group.head, space.Describe(*first, states)))
      .WithLabel(fmt::format("{} stays as it is in {} of {} environments",
                             group.head, none.Count(), *space.size()));
}

std::optional<Diagnostic> JoinWarning(const Group& group,
                                      const TruthTable& several,
                                      const StateSpace& space,
                                      const std::vector<State>& states) {
  const std::optional<int> first = several.First();
  if (!first) return std::nullopt;
  const std::vector<double> values = space.At(*first);
  std::vector<Span> active;
  for (std::size_t i = 0; i < group.rules.size(); ++i)
    if (ClauseHolds(group.rules[i].clause, values))
      active.push_back(group.written[i].clause);
  assert(active.size() >= 2);
  return Diagnostic(
             Code::kSeveralActiveRules, active[1],
             fmt::format("{} rules for '{}' are active when {}", active.size(),
                         group.head, space.Describe(*first, states)))
      .WithLabel(fmt::format("joined in {} of {} environments", several.Count(),
                             *space.size()))
      .WithOther(active[0], "holds there too")
      .WithHelp(fmt::format(
          "make the clauses exclude each other, or write '# plsc: allow {}' "
          "if the productions are meant to be joined",
          NumberOf(Code::kSeveralActiveRules)));
}

void LintGroup(const Group& group, const std::vector<State>& states,
               Reporter* reporter) {
  std::vector<const Clause*> clauses;
  for (const Rule& rule : group.rules) clauses.push_back(&rule.clause);
  const StateSpace space(clauses, states);
  if (!space.size()) {
    reporter->Report(Code::kUnchecked, group.written[0].head,
                     fmt::format("the clauses for '{}' tell apart more than {} "
                                 "environments; not checked",
                                 group.head, StateSpace::kMaxCombinations));
    return;
  }
  const Coverage coverage = Cover(group.rules, space);
  if (auto gap = GapWarning(group, coverage.none, space, states))
    reporter->Add(std::move(*gap));
  // Beside a rule that is always active, others can only be meant to be
  // joined.
  if (coverage.has_constant) return;
  if (auto join = JoinWarning(group, coverage.several, space, states))
    reporter->Add(std::move(*join));
}

}  // namespace

std::vector<Diagnostic> LintClauses(const Program& program,
                                    const SourceMap& map) {
  const Genotype& genotype = program.genotype;
  assert(map.rules.size() == genotype.rules.size());
  Reporter reporter;
  const std::span<const Rule> rules = genotype.rules;
  for (std::size_t begin = 0; begin < rules.size();) {
    std::size_t end = begin + 1;
    while (end < rules.size() && rules[end].head == rules[begin].head) ++end;
    const Group group{genotype.SymbolOf(rules[begin].head).name,
                      rules.subspan(begin, end - begin),
                      std::span(map.rules).subspan(begin, end - begin)};
    LintGroup(group, genotype.states, &reporter);
    begin = end;
  }
  return reporter.Take();
}

}  // namespace plsc
