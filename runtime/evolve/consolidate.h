#pragma once

// One number for the fitness of many seasons (paper, Eq. 3; authors'
// program, population.py:167): how many others an individual dominates.

#include <functional>
#include <optional>
#include <vector>

namespace plsc {

/// One entry a season; nothing where there is no fitness, which is worse than
/// any number and equal to nothing.
using SeasonFitnesses = std::vector<std::optional<double>>;

/// Pareto: not worse in any season and better in at least one. Both have the
/// same number of seasons, any. (The authors' arithmetic equals this for one
/// or two seasons and errs for more.)
bool Dominates(const SeasonFitnesses& a, const SeasonFitnesses& b);

/// Of each individual, the number of others that it dominates: the
/// consolidated fitness, comparable only within the same set. With one season
/// it orders individuals exactly as their fitness does. Takes time by the
/// square of the set; fewer where `should_stop`, asked between individuals,
/// says so.
std::vector<int> DominationCounts(
    const std::vector<SeasonFitnesses>& set,
    const std::function<bool()>& should_stop = {});

}  // namespace plsc
