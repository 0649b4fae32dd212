#pragma once

// Environments in which exactly the same rules are active develop alike: one
// regime. A genotype has far fewer of them than environments, so that it can
// be developed in each.

#include <optional>
#include <vector>

#include "compiler/state_space.h"
#include "runtime/develop/regulate.h"

namespace plsc {

struct Regime {
  int environment = 0;  ///< the first of its environments in the space
  int count = 0;        ///< how many environments of the space it has
};

/// Rules times environments that FindRegimes looks at, at most: a thousand
/// rules in 65,536 environments. Keeps a hostile file from stalling a lint.
inline constexpr std::size_t kMaxRegulations = std::size_t{1} << 26;

/// All regimes in the order of their first environments; `space` is that of
/// the genotype. Nothing when the space has no size, or with more than
/// kMaxRegulations.
std::optional<std::vector<Regime>> FindRegimes(const Genotype& genotype,
                                               const StateSpace& space);

}  // namespace plsc
