// Warnings in three layers: about clauses alone (compiler/lint), about how long
// strings grow, about what is expressed. A layer is asked only where the one
// before leaves it something to say: no environment can stand for the others
// where clauses tell apart too many, and what is too long to develop expresses
// nothing.
//
// Environments are not gone through one by one but by regimes, whose
// environments all have the same active rules (develop/regimes), and a length
// is computed without the string (develop/growth): a genotype that would grow
// beyond any memory is warned of at once.

#include "runtime/advice/lint.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "compiler/lint.h"
#include "compiler/suppress.h"
#include "grammar/parse.h"
#include "runtime/advice/lint_expression.h"
#include "runtime/develop/derive.h"
#include "runtime/develop/growth.h"
#include "runtime/develop/regimes.h"

namespace plsc {

namespace {

// What to blame for growth: the number of rewritings.
Span GrowthSpan(const MappedProgram& compiled) {
  if (compiled.map.iterations.end > 0) return compiled.map.iterations;
  const Genotype& genotype = compiled.program.genotype;
  for (std::size_t i = 0; i < genotype.rules.size(); ++i)
    if (genotype.rules[i].head == genotype.axiom)
      return compiled.map.rules[i].head;
  return compiled.map.version;
}

std::string LengthText(std::uint64_t length) {
  if (length == std::numeric_limits<std::uint64_t>::max())
    return "more than 10^19";
  return fmt::format("{}", length);
}

Diagnostic Growth(Code code, const MappedProgram& compiled,
                  const ActiveRules& active, std::uint64_t length,
                  const std::string& where) {
  const Genotype& genotype = compiled.program.genotype;
  Diagnostic diagnostic(
      code, GrowthSpan(compiled),
      fmt::format(
          "{}, development would produce {} symbols, and the limit is {}",
          where, LengthText(length), kMaxStringLength));
  if (const auto multiplier = GreatestMultiplier(active))
    diagnostic.label = fmt::format(
        "each '{}' becomes {} symbols, {} of them '{}' again",
        genotype.SymbolOf(multiplier->symbol).name, multiplier->length,
        multiplier->copies, genotype.SymbolOf(multiplier->symbol).name);
  diagnostic.help = fmt::format(
      "lower 'iterations' (now {}), or let rules bring back fewer replaceable "
      "symbols",
      genotype.development.iterations);
  return diagnostic;
}

// In the environment where the string grows most.
std::optional<Diagnostic> GrowthWarning(const MappedProgram& compiled,
                                        const StateSpace& space,
                                        const std::vector<Regime>& regimes) {
  const Genotype& genotype = compiled.program.genotype;
  int environments = 0;
  std::uint64_t longest = 0;
  const Regime* worst = nullptr;
  for (const Regime& regime : regimes) {
    const std::uint64_t length = DerivedLength(
        genotype, Regulate(genotype, {space.At(regime.environment)}));
    if (length <= kMaxStringLength) continue;
    environments += regime.count;
    if (length <= longest) continue;
    longest = length;
    worst = &regime;
  }
  if (worst == nullptr) return std::nullopt;
  const std::string where =
      *space.size() == 1
          ? "in every environment"
          : "when " + space.Describe(worst->environment, genotype.states);
  return Growth(Code::kMayGrowTooLong, compiled,
                Regulate(genotype, {space.At(worst->environment)}), longest,
                where)
      .WithNote(fmt::format("too long in {} of {} environments", environments,
                            *space.size()));
}

Diagnostic TooManyEnvironments(Span version) {
  return Diagnostic(
             Code::kUnchecked, version,
             "the clauses tell apart too many environments to develop in each")
      .WithLabel("growth and expression of symbols are not checked");
}

}  // namespace

std::vector<Diagnostic> LintGenotype(const MappedProgram& compiled) {
  const Genotype& genotype = compiled.program.genotype;
  std::vector<Diagnostic> warnings =
      LintClauses(compiled.program, compiled.map);
  const StateSpace space(genotype);
  const auto regimes = FindRegimes(ClausesOf(genotype), space);
  if (!regimes) {
    warnings.push_back(TooManyEnvironments(compiled.map.version));
    return warnings;
  }
  if (auto growth = GrowthWarning(compiled, space, *regimes)) {
    // What is too long to develop has nothing to say about expression.
    warnings.push_back(std::move(*growth));
    return warnings;
  }
  std::vector<Diagnostic> more =
      LintExpression(compiled, space, *regimes, compiled.map.version);
  std::move(more.begin(), more.end(), std::back_inserter(warnings));
  return warnings;
}

std::vector<Diagnostic> Lint(std::span<const MappedProgram> compiled,
                             const Source& source) {
  std::vector<Diagnostic> warnings;
  for (const MappedProgram& one : compiled) {
    std::vector<Diagnostic> more = LintGenotype(one);
    std::move(more.begin(), more.end(), std::back_inserter(warnings));
  }
  const ParseResult parsed = Parse(source);
  warnings = Suppressions(parsed.file).Keep(std::move(warnings));
  SortAndDropRepeated(&warnings);
  return warnings;
}

Diagnostic GrowthError(const MappedProgram& compiled, const ActiveRules& active,
                       std::uint64_t length, const std::string& where) {
  return Growth(Code::kTooLongString, compiled, active, length, "in " + where);
}

}  // namespace plsc
