#pragma once

// How the robots of a generation do, season by season, told again after each
// of them: so it is kept in order instead of being sorted each time.

#include <optional>
#include <string>
#include <vector>

#include "runtime/life/season_result.h"

namespace plsc {

/// The best and the middle fitness of one season, m/s; nothing where that
/// robot has no fitness.
struct SeasonProgress {
  std::string season;
  std::optional<double> best;
  std::optional<double> median;  ///< the lower of two in the middle
};

class SeasonSummary {
 public:
  /// One that is not evaluated yet changes nothing.
  void Add(const Evaluation& evaluation);
  /// Of all that were added; empty if none was.
  std::vector<SeasonProgress> Summaries() const;

 private:
  struct Season {
    std::string name;
    std::vector<std::optional<double>> fitnesses;  // ascending, nothing first
  };
  std::vector<Season> seasons_;
};

}  // namespace plsc
