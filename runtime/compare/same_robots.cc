// A proof by going through all cases: there are finitely many, because
// environments with the same active rules develop alike. The cases are the
// regimes of the rules of both genotypes together, as either clause may tell
// apart what the other does not; in each, both are developed and their keys
// compared, which are equal only for the same bits. Regimes times the length of
// the strings.

#include "runtime/compare/same_robots.h"

#include <algorithm>
#include <utility>

#include "compiler/state_space.h"
#include "runtime/develop/developed.h"
#include "runtime/develop/regimes.h"

namespace plsc {

namespace {

std::optional<Key> KeyIn(const Genotype& genotype, const ActiveRules& active) {
  const auto developed = DevelopActive(genotype, active);
  if (!developed) return std::nullopt;
  return DevelopedKey(genotype, *developed);
}

}  // namespace

std::optional<std::vector<ComparedRegime>> CompareRegimes(
    const Genotype& before, const Genotype& after,
    const std::vector<NamedEnvironment>& named, Compared which) {
  const std::vector<const Clause*> clauses = ClausesOf(before, after);
  const StateSpace space(clauses, before.states);
  const auto regimes = FindRegimes(clauses, space);
  if (!regimes) return std::nullopt;
  std::vector<ComparedRegime> compared;
  for (const Regime& regime : *regimes) {
    const Environment environment{space.At(regime.environment)};
    const ActiveRules active_before = Regulate(before, environment);
    const ActiveRules active_after = Regulate(after, environment);
    ComparedRegime one{space.Describe(regime.environment, before.states),
                       regime.count,
                       {},
                       {},
                       {}};
    for (const NamedEnvironment& other : named)
      if (Regulate(before, other.environment).rules == active_before.rules &&
          Regulate(after, other.environment).rules == active_after.rules)
        one.named.push_back(other.name);
    if (which == Compared::kNamed && one.named.empty()) continue;
    const auto key_before = KeyIn(before, active_before);
    const auto key_after = KeyIn(after, active_after);
    if (!key_before || !key_after) return std::nullopt;
    one.before = *key_before;
    one.after = *key_after;
    compared.push_back(std::move(one));
  }
  return compared;
}

bool AreSame(const std::vector<ComparedRegime>& regimes) {
  return std::all_of(regimes.begin(), regimes.end(),
                     [](const ComparedRegime& regime) {
                       return regime.before == regime.after;
                     });
}

}  // namespace plsc
