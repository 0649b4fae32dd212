// "The same robots everywhere" for one genotype, asked thousands of times.
// Environments with the same active rules develop alike, so robots are kept by
// the set of active rules (`developed`), and only regimes are looked at.
//
// Which regimes must be looked at depends on what was left out. Without symbols
// no clause is another one, and the regimes stay. Without a rule the old
// regimes still suffice, since they tell apart all that the new ones do.
// Without a term they do not: a shorter clause may be true where it was not, in
// the middle of an old regime, so those of both genotypes together are taken.
// There the same rules must be active, too, not only the same robots: a clause
// that is true more often, if for nothing, is not a shorter way to say the
// same.
//
// Robots are compared by value and by key, since -0 equals 0 and is another
// bit. Lengths are counted before strings are derived (growth): they are the
// measure of the work, and no string beyond its limit is begun.
//
// A try costs one development for each set of active rules that was not
// developed before, over the regimes that must be looked at; `work_` counts it
// in symbols.

#include "runtime/advice/trim_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "runtime/advice/expectations.h"
#include "runtime/advice/lint.h"
#include "runtime/develop/derive.h"
#include "runtime/develop/growth.h"

namespace plsc {

namespace {

std::vector<std::size_t> PassingTests(const MappedProgram& mapped) {
  std::vector<std::size_t> passing;
  for (std::size_t i = 0; i < mapped.program.tests.size(); ++i)
    if (!RunInlineTest(mapped, i)) passing.push_back(i);
  return passing;
}

Diagnostic TooManyEnvironments(const MappedProgram& mapped) {
  return Diagnostic(
             Code::kTooManyEnvironments,
             mapped.map.genotype.end > 0 ? mapped.map.genotype
                                         : mapped.map.version,
             fmt::format("clauses that tell apart at most {} environments are "
                         "expected, to develop in each",
                         StateSpace::kMaxCombinations))
      .WithLabel("nothing can be proved of all environments here")
      .WithHelp("let clauses ask about fewer states or thresholds");
}

// Those that some environment that counts is in: where the same rules are
// active, the same develops.
std::vector<Regime> Counted(std::vector<Regime> regimes,
                            const std::vector<const Clause*>& clauses,
                            const StateSpace& space,
                            const LivedEnvironments& lived) {
  if (!lived) return regimes;
  std::set<std::vector<bool>> holding;
  for (const NamedEnvironment& one : *lived)
    holding.insert(WhichHold(clauses, one.environment.values));
  std::erase_if(regimes, [&](const Regime& regime) {
    return !holding.contains(WhichHold(clauses, space.At(regime.environment)));
  });
  return regimes;
}

std::string WhereOf(const TrimTarget& target, const Regime& regime) {
  if (*target.space.size() == 1) return "every environment";
  return "an environment with " +
         target.space.Describe(regime.environment, target.current.states);
}

std::optional<Diagnostic> DevelopAll(TrimTarget& target) {
  for (const Regime& regime : target.regimes) {
    const ActiveRules active =
        Regulate(target.current, {target.space.At(regime.environment)});
    const std::uint64_t length = DerivedLength(target.current, active);
    if (length > kMaxStringLength)
      return GrowthError(*target.mapped, active, length,
                         WhereOf(target, regime));
    target.developed[active.rules] = *DevelopActive(target.current, active);
  }
  return std::nullopt;
}

// The key tells -0 from 0, which compare as equal.
bool IsSame(const Genotype& genotype, const Developed& a, const Developed& b) {
  return a == b && DevelopedKey(genotype, a) == DevelopedKey(genotype, b);
}

// One try of a genotype in a target's place.
class Attempt {
 public:
  Attempt(const TrimTarget& target, Genotype genotype)
      : target_(target), next_{target.mapped,       target.lived, target.space,
                               std::move(genotype), {},           {},
                               target.tests} {}

  TrimTry Run(PieceKind kind) {
    const bool is_fine = DevelopsTheSame(kind) && PassesTests();
    if (!is_fine) return {std::nullopt, work_};
    return {std::move(next_), work_};
  }

 private:
  std::vector<Regime> RegimesOf(const std::vector<const Clause*>& clauses) {
    // An eighth: a clause is looked up faster than a symbol is derived.
    work_ +=
        clauses.size() * static_cast<std::size_t>(*target_.space.size()) / 8;
    return Counted(*FindRegimes(clauses, target_.space), clauses, target_.space,
                   target_.lived);
  }

  // The environments to look at: without symbols or rules no more are told
  // apart, but without terms others may be.
  std::vector<Regime> RegimesOfBoth() {
    return RegimesOf(ClausesOf(target_.current, next_.current));
  }

  bool DevelopsTheSame(PieceKind kind) {
    next_.regimes = kind == PieceKind::kSymbol
                        ? target_.regimes
                        : RegimesOf(ClausesOf(next_.current));
    const std::vector<Regime> regimes =
        kind == PieceKind::kTerm ? RegimesOfBoth() : target_.regimes;
    return std::all_of(regimes.begin(), regimes.end(),
                       [&](const Regime& regime) {
                         return DevelopsTheSameIn(
                             {target_.space.At(regime.environment)}, kind);
                       });
  }

  bool DevelopsTheSameIn(const Environment& environment, PieceKind kind) {
    // Regulating twice and comparing takes as long as some symbols.
    work_ += 32;
    const ActiveRules active = Regulate(next_.current, environment);
    const ActiveRules before = Regulate(target_.current, environment);
    // A clause is not shorter where its rule is active more often, be it for
    // nothing.
    if (kind == PieceKind::kTerm && active.rules != before.rules) return false;
    const Developed& wanted = target_.developed.at(before.rules);
    const auto known = next_.developed.find(active.rules);
    if (known != next_.developed.end())
      return IsSame(next_.current, known->second, wanted);
    const std::uint64_t length = DerivedLength(next_.current, active);
    if (length > kMaxStringLength) return false;
    work_ += length;
    auto developed = DevelopActive(next_.current, active);
    if (!IsSame(next_.current, *developed, wanted)) return false;
    next_.developed[active.rules] = std::move(*developed);
    return true;
  }

  bool PassesTests() const {
    if (next_.tests.empty()) return true;
    const Program& program = target_.mapped->program;
    const MappedProgram mapped{
        {next_.current, program.environments, program.tests},
        target_.mapped->map};
    return std::none_of(
        next_.tests.begin(), next_.tests.end(),
        [&](std::size_t test) { return RunInlineTest(mapped, test); });
  }

  const TrimTarget& target_;
  TrimTarget next_;
  std::uint64_t work_ = 0;
};

}  // namespace

Result<TrimTarget> MakeTrimTarget(const MappedProgram& mapped,
                                  LivedEnvironments lived) {
  const Genotype& genotype = mapped.program.genotype;
  TrimTarget target{
      &mapped, std::move(lived), StateSpace(genotype), genotype, {}, {}, {}};
  const std::vector<const Clause*> clauses = ClausesOf(genotype);
  const auto regimes = FindRegimes(clauses, target.space);
  // Proofs look at the rules of before and after together.
  const bool is_too_much =
      !regimes ||
      genotype.rules.size() >
          kMaxRegulations / 2 / static_cast<std::size_t>(*target.space.size());
  if (is_too_much) return TooManyEnvironments(mapped);
  target.regimes = Counted(*regimes, clauses, target.space, target.lived);
  if (auto problem = DevelopAll(target)) return *problem;
  target.tests = PassingTests(mapped);
  return target;
}

TrimTry TryGenotype(const TrimTarget& target, Genotype genotype,
                    PieceKind kind) {
  return Attempt(target, std::move(genotype)).Run(kind);
}

}  // namespace plsc
