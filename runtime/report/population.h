#pragma once

// What became of a run's population, generation by generation: means of
// measures over its robots, those of the best one, and censuses. Robots are
// read once each, however many generations they live, and none is kept.

#include <string>
#include <vector>

#include "runtime/report/quantiles.h"
#include "runtime/store/census.h"
#include "runtime/store/database.h"
#include "runtime/study/report_measures.h"

namespace plsc {

/// One measure in one season, by generation. No number where no robot has a
/// value: means leave out robots that did not develop and, of behaviour, lives
/// that were not completed.
struct Series {
  std::vector<double> means;       ///< in the shown unit
  std::vector<Quartiles> spreads;  ///< over robots; empty unless asked for
  std::vector<double> best;        ///< of each generation's best robot
};

/// How far joints were from what their servos were told in a season, of the
/// survivors of the last generation: whether the solver converged. rad/s, no
/// number where a store has none.
struct SeasonErrors {
  double median = 0;  ///< of the robots' medians
  double worst = 0;   ///< of any robot
};

struct PopulationSummary {
  std::vector<std::string> seasons;    ///< names, in the scenario's order
  int generations = 0;                 ///< completed
  std::vector<Series> series;          ///< a measure's seasons side by side
  std::vector<SeasonErrors> errors;    ///< by season; empty before generation 0
  std::vector<CensusCounts> censuses;  ///< by generation
  std::vector<int> survivors;          ///< of the last one: ids, by rank

  const Series& of(std::size_t measure, std::size_t season) const {
    return series[measure * seasons.size() + season];
  }
};

/// What cannot be read is a failure of the database; the summary is worth
/// nothing then. `with_spread`: quartiles over robots, too. Without censuses,
/// which need to know the experiment (CensusOf).
PopulationSummary SummarisePopulation(
    Database& database, const std::vector<ReportMeasure>& measures,
    bool with_spread);

}  // namespace plsc
