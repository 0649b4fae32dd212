#pragma once

// One run as a report shows it, read from its store in one go: nothing of the
// store is changed, whoever works on it meanwhile is not disturbed, and what
// is kept is aggregates.

#include <optional>
#include <string>
#include <vector>

#include "runtime/report/population.h"
#include "runtime/report/robots.h"
#include "runtime/report/run_facts.h"
#include "runtime/study/run_report.h"

namespace plsc {

struct RunReading {
  RunState state = RunState::kMissing;
  std::string problem;  ///< kDamaged only: ready for the user
  std::string worker;   ///< kRunning only: "process 17 on host"
  /// The rest is empty if the run is missing or damaged.
  Experiment experiment;
  RunFacts facts;
  PopulationSummary population;
  std::optional<Portrait> best;  ///< of the last completed generation
  std::vector<RuleCount> rules;  ///< of its robots, if these have clauses
};

struct ReadOptions {
  std::vector<ReportMeasure> measures;
  bool with_spread = false;  ///< as SummarisePopulation's
  bool verify = false;       ///< all rows; what is damaged is not read
};

/// `expected`: the run that must be there, if that is known.
RunReading ReadRun(const std::string& path, const ReadOptions& options,
                   const std::optional<Experiment>& expected = std::nullopt);

}  // namespace plsc
