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

namespace plsc {

namespace {

Diagnostic Make(const char* code, Span span, std::string message) {
  Diagnostic diagnostic;
  diagnostic.code = code;
  diagnostic.span = span;
  diagnostic.message = std::move(message);
  return diagnostic;
}

void CheckTermLimit(const ast::File& file, const Scope& scope,
                    std::vector<Diagnostic>* diagnostics) {
  if (!scope.header.max_terms) return;
  const auto limit = static_cast<std::uint32_t>(*scope.header.max_terms);
  for (const ast::Rule& rule : file.rules) {
    if (rule.terms.count <= limit || diagnostics->size() >= kMaxReported)
      continue;
    Diagnostic diagnostic =
        Make("P3001", rule.clause,
             fmt::format("clause has {} terms; this genotype allows at most {}",
                         rule.terms.count, limit));
    diagnostic.others.push_back({scope.max_terms_span, "declared here"});
    diagnostics->push_back(std::move(diagnostic));
  }
}

void CheckRuleLimit(const ast::File& file, const Scope& scope,
                    const Resolution& resolution,
                    std::vector<Diagnostic>* diagnostics) {
  if (file.rules.size() > kMaxRuleCount)
    diagnostics->push_back(
        Make("P3002", file.rules[kMaxRuleCount].head,
             fmt::format("a genotype has at most {} rules", kMaxRuleCount)));
  if (!scope.header.max_rules) return;
  const int limit = *scope.header.max_rules;
  std::map<SymbolId, int> counts;
  for (std::size_t i = 0; i < file.rules.size(); ++i) {
    const auto head = resolution.heads[i];
    if (!head || ++counts[*head] != limit + 1) continue;
    Diagnostic diagnostic =
        Make("P3001", file.rules[i].head,
             fmt::format(
                 "'{}' has more than {} rule{}, which this genotype allows "
                 "at most",
                 file.Text(file.rules[i].head), limit, limit == 1 ? "" : "s"));
    diagnostic.others.push_back({scope.max_rules_span, "declared here"});
    diagnostics->push_back(std::move(diagnostic));
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
      if (diagnostics_.size() >= kMaxReported) break;
      const auto [first, is_new] =
          names.emplace(file_.Text(environment.name), environment.name);
      if (!is_new) {
        diagnostics_.push_back(
            Make("P2017", environment.name,
                 fmt::format("environment '{}' is declared twice",
                             file_.Text(environment.name))));
        diagnostics_.back().others.push_back(
            {first->second, "first declared here"});
      }
      CheckOne(environment);
    }
    return std::move(diagnostics_);
  }

 private:
  void CheckOne(const ast::Environment& environment) {
    const std::vector<State>& states = scope_.header.states;
    std::vector<Span> given(states.size());
    bool all_known = true;
    for (std::uint32_t k = 0; k < environment.entries.count; ++k) {
      if (diagnostics_.size() >= kMaxReported) return;
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
    if (given->end != 0) {
      diagnostics_.push_back(
          Make("P2015", entry.span,
               fmt::format("state '{}' is given twice", state.name)));
      diagnostics_.back().others.push_back({*given, "first given here"});
    }
    *given = entry.span;
    if (state.type == StateType::kReal &&
        (resolved.value < state.low || resolved.value > state.high))
      diagnostics_.push_back(
          Make("P2015", entry.value.span,
               fmt::format("{} is outside the range {}..{} of state '{}'",
                           file_.Text(entry.value.span), PrintNumber(state.low),
                           PrintNumber(state.high), state.name)));
  }

  void CheckComplete(const ast::Environment& environment,
                     const std::vector<Span>& given) {
    std::vector<std::string> missing;
    for (std::size_t i = 0; i < given.size(); ++i)
      if (given[i].end == 0)
        missing.push_back(fmt::format("'{}'", scope_.header.states[i].name));
    if (missing.empty()) return;
    Diagnostic diagnostic = Make(
        "P2015", environment.name,
        fmt::format("environment '{}' lacks a value for {}",
                    file_.Text(environment.name), fmt::join(missing, ", ")));
    diagnostic.label = "every declared state needs one";
    diagnostics_.push_back(std::move(diagnostic));
  }

  const ast::File& file_;
  const Scope& scope_;
  const Resolution& resolution_;
  std::vector<Diagnostic> diagnostics_;
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
  std::vector<Diagnostic> diagnostics;
  if (scope.header.alphabet != nullptr)
    diagnostics = CheckSymbols(file, scope, resolution, options);
  CheckTermLimit(file, scope, &diagnostics);
  CheckRuleLimit(file, scope, resolution, &diagnostics);
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
  std::vector<Diagnostic> warnings;
  const std::vector<State>& states = scope.header.states;
  for (const ast::Rule& rule : file.rules) {
    const Clause clause = LowerClause(file, rule, resolution);
    if (!MayBeConstant(clause, states)) continue;
    const auto count = CountTruth(clause, states);
    if (!count || (count->holds != 0 && count->holds != count->total)) continue;
    const bool is_always = count->holds != 0;
    Diagnostic warning =
        Make("W3002", rule.clause,
             fmt::format("this clause is {} in every environment",
                         is_always ? "true" : "false"));
    warning.severity = Severity::kWarning;
    warning.label = fmt::format("whatever {} is", StateNames(clause, states));
    warning.help = is_always ? "without the clause the rule is always active"
                             : "this rule is never active";
    warnings.push_back(std::move(warning));
    if (warnings.size() >= kMaxReported) break;
  }
  return warnings;
}

}  // namespace plsc
