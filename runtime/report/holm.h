#pragma once

// Holm's correction: p-values of tests that are looked at together, so that the
// odds of one false alarm or more stay those of a single test.

#include <optional>
#include <vector>

namespace plsc {

/// R's p.adjust(p, "holm", n): each in its place. Nothing, of a test that could
/// not be made, counts as a test nevertheless: the family was stated before.
std::vector<std::optional<double>> HolmAdjusted(
    const std::vector<std::optional<double>>& family);

}  // namespace plsc
