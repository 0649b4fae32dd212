// Refinement of a partition: all environments are one class at first, and each
// rule splits every class into where its clause holds and where not. What is
// left together has the same active rules, whatever they are, so one
// development tells for all of a class. Taking each environment's set of active
// rules as its name would give the same, with a set a row to compare.
//
// Classes are numbered anew for each rule as the rows meet them, so that at all
// times lower numbers have earlier first environments: the order in which
// regimes are handed out, and which messages and trimming depend on. Rules
// times environments steps, bounded by kMaxRegulations.

#include "runtime/develop/regimes.h"

#include <array>

#include "compiler/truth.h"

namespace plsc {

std::optional<std::vector<Regime>> FindRegimes(
    std::span<const Clause* const> clauses, const StateSpace& space) {
  if (!space.size()) return std::nullopt;
  const auto size = static_cast<std::size_t>(*space.size());
  if (clauses.size() > kMaxRegulations / size) return std::nullopt;
  // One class of all environments, split by each rule into those where it is
  // active and those where it is not.
  std::vector<int> class_of(size, 0);
  int class_count = 1;
  for (const Clause* clause : clauses) {
    if (clause->is_always()) continue;
    const TruthTable table = Tabulate(*clause, space);
    constexpr std::array<int, 2> kNone{-1, -1};
    std::vector<std::array<int, 2>> parts(static_cast<std::size_t>(class_count),
                                          kNone);
    int next = 0;
    for (std::size_t i = 0; i < size; ++i) {
      int& part = parts[static_cast<std::size_t>(class_of[i])]
                       [table[static_cast<int>(i)] ? 1 : 0];
      if (part < 0) part = next++;
      class_of[i] = part;
    }
    class_count = next;
  }
  std::vector<Regime> regimes(static_cast<std::size_t>(class_count));
  for (std::size_t i = 0; i < size; ++i) {
    Regime& regime = regimes[static_cast<std::size_t>(class_of[i])];
    if (regime.count++ == 0) regime.environment = static_cast<int>(i);
  }
  return regimes;
}

std::vector<bool> WhichHold(std::span<const Clause* const> clauses,
                            std::span<const double> values) {
  std::vector<bool> holding;
  holding.reserve(clauses.size());
  for (const Clause* clause : clauses)
    holding.push_back(ClauseHolds(*clause, values));
  return holding;
}

}  // namespace plsc
