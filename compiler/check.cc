// What is wrong although every name is found. Each check looks at what Resolve
// could give a number to and passes over the rest, which was reported there.
// Where an item failed to parse or an entry is wrong, nothing is called
// missing: it may be just that.
//
// Warnings about clauses (CheckClauses) are only made of files without errors,
// from truth tables (truth). A hostile clause can be expensive to tabulate, so
// only clauses that could be constant are, and the tables have their own bound.

#include "compiler/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>

#include "compiler/check_symbols.h"
#include "compiler/check_tests.h"
#include "compiler/limits.h"
#include "compiler/lower.h"
#include "compiler/truth.h"
#include "grammar/number.h"
#include "grammar/reporter.h"

namespace plsc {

namespace {

void CheckTermLimit(const ast::File& file, const Scope& scope,
                    Reporter* reporter) {
  if (!scope.header.max_terms) return;
  const auto limit = static_cast<std::uint32_t>(*scope.header.max_terms);
  for (const ast::Rule& rule : file.rules) {
    if (rule.terms.count <= limit) continue;
    reporter
        ->Report(
            Code::kOwnLimit, rule.clause,
            fmt::format("clause has {} terms; this genotype allows at most {}",
                        rule.terms.count, limit))
        .WithOther(scope.max_terms_span, "declared here");
  }
}

void CheckRuleLimit(const ast::File& file, const Scope& scope,
                    const Resolution& resolution, Reporter* reporter) {
  if (file.rules.size() > kMaxRuleCount)
    reporter->Report(
        Code::kLimit, file.rules[kMaxRuleCount].head,
        fmt::format("a genotype has at most {} rules", kMaxRuleCount));
  if (!scope.header.max_rules) return;
  const int limit = *scope.header.max_rules;
  std::map<SymbolId, int> counts;
  for (std::size_t i = 0; i < file.rules.size(); ++i) {
    const auto head = resolution.heads[i];
    if (!head || ++counts[*head] != limit + 1) continue;
    reporter
        ->Report(
            Code::kOwnLimit, file.rules[i].head,
            fmt::format(
                "'{}' has more than {} rule{}, which this genotype allows "
                "at most",
                file.Text(file.rules[i].head), limit, limit == 1 ? "" : "s"))
        .WithOther(scope.max_rules_span, "declared here");
  }
}

class EnvironmentChecker {
 public:
  EnvironmentChecker(const ast::File& file, const Scope& scope,
                     const Resolution& resolution)
      : file_(file), scope_(scope), resolution_(resolution) {}

  std::vector<Diagnostic> Check() {
    std::unordered_map<std::string_view, Span> names;
    for (const ast::Environment& environment : file_.environments) {
      if (reporter_.is_full()) break;
      const auto [first, is_new] =
          names.emplace(file_.Text(environment.name), environment.name);
      if (!is_new)
        reporter_
            .Report(Code::kRepeatedName, environment.name,
                    fmt::format("environment '{}' is declared twice",
                                file_.Text(environment.name)))
            .WithOther(first->second, "first declared here");
      CheckOne(environment);
    }
    return reporter_.Take();
  }

 private:
  void CheckOne(const ast::Environment& environment) {
    const std::vector<State>& states = scope_.header.states;
    std::vector<Span> given(states.size());
    bool all_known = true;
    for (std::uint32_t k = 0; k < environment.entries.count; ++k) {
      if (reporter_.is_full()) return;
      const std::uint32_t at = environment.entries.first + k;
      const ResolvedTerm& entry = resolution_.entries[at];
      if (!entry) {
        all_known = false;
        continue;
      }
      CheckEntry(file_.entries[at], *entry,
                 &given[static_cast<std::size_t>(entry->state)]);
    }
    // With an entry that is wrong, what is missing may be what it meant.
    if (all_known && !file_.is_incomplete) CheckComplete(environment, given);
  }

  void CheckEntry(const ast::Entry& entry, const Term& resolved, Span* given) {
    const State& state = scope_.header.StateOf(resolved.state);
    if (given->end != 0)
      reporter_
          .Report(Code::kWrongEnvironment, entry.span,
                  fmt::format("state '{}' is given twice", state.name))
          .WithOther(*given, "first given here");
    *given = entry.span;
    if (state.type == StateType::kReal &&
        (resolved.value < state.low || resolved.value > state.high))
      reporter_.Report(
          Code::kWrongEnvironment, entry.value.span,
          fmt::format("{} is outside the range {}..{} of state '{}'",
                      file_.Text(entry.value.span), PrintNumber(state.low),
                      PrintNumber(state.high), state.name));
  }

  void CheckComplete(const ast::Environment& environment,
                     const std::vector<Span>& given) {
    std::vector<std::string> missing;
    for (std::size_t i = 0; i < given.size(); ++i)
      if (given[i].end == 0)
        missing.push_back(fmt::format("'{}'", scope_.header.states[i].name));
    if (missing.empty()) return;
    reporter_
        .Report(
            Code::kWrongEnvironment, environment.name,
            fmt::format("environment '{}' lacks a value for {}",
                        file_.Text(environment.name), fmt::join(missing, ", ")))
        .WithLabel("every declared state needs one");
  }

  const ast::File& file_;
  const Scope& scope_;
  const Resolution& resolution_;
  Reporter reporter_;
};

std::string StateNames(const Clause& clause, const std::vector<State>& states) {
  std::vector<std::string> names;
  for (const Term& term : clause.terms) {
    const std::string& name = StateAt(states, term.state).name;
    if (std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

// A single bool or enum term is never constant: there are two values at least.
bool MayBeConstant(const Clause& clause, const std::vector<State>& states) {
  if (clause.terms.size() != 1) return !clause.terms.empty();
  const auto state = static_cast<std::size_t>(clause.terms[0].state);
  return states[state].type == StateType::kReal;
}

}  // namespace

std::vector<Diagnostic> Check(const ast::File& file, const Scope& scope,
                              const Resolution& resolution,
                              const CompileOptions& options) {
  Reporter reporter;
  if (scope.header.alphabet != nullptr)
    CheckSymbols(file, scope, resolution, options, &reporter);
  CheckTermLimit(file, scope, &reporter);
  CheckRuleLimit(file, scope, resolution, &reporter);
  std::vector<Diagnostic> diagnostics = reporter.Take();
  std::vector<Diagnostic> environments =
      EnvironmentChecker(file, scope, resolution).Check();
  std::move(environments.begin(), environments.end(),
            std::back_inserter(diagnostics));
  if (!file.tests.empty()) {
    std::vector<Diagnostic> tests = CheckTests(file, scope, resolution);
    std::move(tests.begin(), tests.end(), std::back_inserter(diagnostics));
  }
  return diagnostics;
}

std::vector<Diagnostic> CheckClauses(const ast::File& file, const Scope& scope,
                                     const Resolution& resolution) {
  Reporter reporter;
  const std::vector<State>& states = scope.header.states;
  for (const ast::Rule& rule : file.rules) {
    if (!reporter.Takes(Severity::kWarning)) break;
    const Clause clause = LowerClause(file, rule, resolution);
    if (!MayBeConstant(clause, states)) continue;
    const auto count = CountTruth(clause, states);
    if (!count || (count->holds != 0 && count->holds != count->total)) continue;
    const bool is_always = count->holds != 0;
    reporter
        .Report(Code::kConstantClause, rule.clause,
                fmt::format("this clause is {} in every environment",
                            is_always ? "true" : "false"))
        .WithLabel(fmt::format("whatever {} is", StateNames(clause, states)))
        .WithHelp(is_always ? "without the clause the rule is always active"
                            : "this rule is never active");
  }
  return reporter.Take();
}

}  // namespace plsc
