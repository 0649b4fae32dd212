#pragma once

// Environments in which exactly the same rules are active develop alike: one
// regime. A genotype has far fewer of them than environments, so that it can
// be developed in each.

#include <optional>
#include <span>
#include <vector>

#include "compiler/state_space.h"

namespace plsc {

struct Regime {
  int environment = 0;  ///< the first of its environments in the space
  int count = 0;        ///< how many environments of the space it has
};

/// Clauses times environments that FindRegimes looks at, at most: a thousand
/// rules in 65,536 environments. Keeps a hostile file from stalling a lint.
inline constexpr std::size_t kMaxRegulations = std::size_t{1} << 26;

/// All regimes of rules with these clauses, in the order of their first
/// environments; `space` knows all states of the clauses. Nothing when the
/// space has no size, or with more than kMaxRegulations.
std::optional<std::vector<Regime>> FindRegimes(
    std::span<const Clause* const> clauses, const StateSpace& space);

/// What tells one regime from another: by clause, whether it holds.
std::vector<bool> WhichHold(std::span<const Clause* const> clauses,
                            std::span<const double> values);

}  // namespace plsc
