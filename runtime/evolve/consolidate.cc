#include "runtime/evolve/consolidate.h"

#include <algorithm>
#include <cassert>

namespace plsc {

bool Dominates(const SeasonFitnesses& a, const SeasonFitnesses& b) {
  assert(a.size() == b.size());
  bool is_better_somewhere = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    // The order of std::optional is the one wanted: nothing is the smallest.
    if (a[i] < b[i]) return false;
    if (a[i] > b[i]) is_better_somewhere = true;
  }
  return is_better_somewhere;
}

std::vector<int> DominationCounts(const std::vector<SeasonFitnesses>& set,
                                  const std::function<bool()>& should_stop) {
  std::vector<int> counts;
  counts.reserve(set.size());
  for (const SeasonFitnesses& one : set) {
    if (should_stop && should_stop()) break;
    counts.push_back(static_cast<int>(std::count_if(
        set.begin(), set.end(),
        [&](const SeasonFitnesses& other) { return Dominates(one, other); })));
  }
  return counts;
}

}  // namespace plsc
