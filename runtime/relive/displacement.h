#pragma once

// Where lives that are lived again start: a little higher than the first time,
// each life and season by chance of its own, and otherwise as they did. It is
// the least that a start can differ by, and enough: what follows is another
// draw from what the robot does (docs/decisions/0021).

#include <cstddef>
#include <cstdint>

#include "runtime/life/disturbances.h"

namespace plsc {

/// m; a third of the clearance that starts have anyway.
inline constexpr double kMostLift = 30e-6;

/// A season each. `n`: which of the robot's lives, from 1. A function of these
/// alone, so that lives can be lived in any order, and more of them later.
Disturbances DisplacedStarts(std::uint64_t seed, int id, int n,
                             std::size_t seasons);

}  // namespace plsc
