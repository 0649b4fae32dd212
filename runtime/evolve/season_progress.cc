#include "runtime/evolve/season_progress.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace plsc {

void SeasonSummary::Add(const Evaluation& evaluation) {
  const std::vector<SeasonResult>& results = evaluation.seasons;
  if (seasons_.empty())
    for (const SeasonResult& result : results)
      seasons_.push_back({result.season, {}});
  assert(results.empty() || results.size() == seasons_.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    auto& fitnesses = seasons_[i].fitnesses;
    fitnesses.insert(std::upper_bound(fitnesses.begin(), fitnesses.end(),
                                      results[i].fitness),
                     results[i].fitness);
  }
}

std::vector<SeasonProgress> SeasonSummary::Summaries() const {
  std::vector<SeasonProgress> told;
  for (const auto& [name, fitnesses] : seasons_)
    told.push_back(
        {name, fitnesses.back(), fitnesses[(fitnesses.size() - 1) / 2]});
  return told;
}

}  // namespace plsc
