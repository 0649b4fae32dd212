#pragma once

// The writing side of a run's store: each function is one transaction, which is
// there as a whole or not at all, and returns what went wrong.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "grammar/failure.h"
#include "runtime/evolve/run_observer.h"
#include "runtime/store/census.h"
#include "runtime/store/checksum.h"
#include "runtime/store/database.h"
#include "runtime/store/run_reader.h"
#include "runtime/store/session.h"
#include "runtime/store/trial_rows.h"

namespace plsc {

struct Versions;

class RunWriter {
 public:
  /// Seasons by name: their ids in the store. `reader` of the same database.
  RunWriter(Database& database, RunReader& reader, const Experiment& experiment,
            std::map<std::string, int> seasons);

  /// Those that are there already must be the same. Writes nothing if
  /// `should_stop` (RunObserver::OnBirths) says so meanwhile.
  MaybeFailure Births(const std::vector<Individual>& born,
                      const std::function<bool()>& should_stop);
  /// In the place of what is there only if a worker had died of it.
  MaybeFailure Evaluated(const Individual& one,
                         const std::vector<SeasonEvidence>& evidence);
  MaybeFailure Completed(const GenerationRecord& record);

 private:
  void AddIndividual(const Individual& one);
  void AddSeason(int individual, const SeasonResult& result,
                 const SeasonEvidence& evidence);
  void AddPhenotype(const SeasonResult& result, const SeasonEvidence& evidence);
  void AddSimulation(const SeasonEvidence& evidence);
  CensusCounts CountSurvivors(const GenerationRecord& record);

  Database& database_;
  RunReader& reader_;
  std::map<std::string, int> seasons_;
  Checksums checksums_;
  Census census_;
  int counted_ = 0;  ///< generations that census_ knows
  Statement header_;
  Statement find_header_;
  Statement individual_;
  Statement sum_individual_;
  Statement rule_;
  Statement find_rule_;
  Statement genotype_rule_;
  Statement body_;
  Statement find_phenotype_;
  Statement phenotype_;
  Statement simulation_;
  Statement evaluation_;
  Statement find_lost_;
  Statement remove_;
  TrialRows trials_;
  Statement sum_evaluation_;
  Statement generation_;
  Statement sum_generation_;
  Statement member_;
};

}  // namespace plsc
