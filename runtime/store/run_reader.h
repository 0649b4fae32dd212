#pragma once

// The reading side of a run's store: rows back into what they were made of.
// What cannot be read is a failure of the database; the values returned then
// are worth nothing.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/evolve/individual.h"
#include "runtime/evolve/run_observer.h"
#include "runtime/evolve/saved_run.h"
#include "runtime/life/simulated.h"
#include "runtime/store/database.h"
#include "runtime/text/key.h"

namespace plsc {

/// An individual as the store has it before it is evaluated.
struct Birth {
  int generation = 0;
  Heritage heritage;
  std::string name;
  std::string genotype;  ///< text
};

class RunReader {
 public:
  explicit RunReader(Database& database);

  /// Nothing if there is no such row.
  std::optional<Birth> FindBirth(int id);
  std::optional<Simulated> FindSimulation(const Key& key);
  /// Fails if there is no such individual.
  Individual FindIndividual(int id);
  Evaluation FindEvaluation(int id);  ///< empty if there is none
  std::vector<SeasonEvidence> FindEvidence(int id);
  std::vector<std::optional<double>> FindFitnesses(int id);
  std::optional<GenerationRecord> FindGeneration(int number);

  int Generations();                        ///< completed
  std::int64_t Evaluations();               ///< individuals with an evaluation
  std::vector<int> EvaluatedSince(int id);  ///< ids from `id` on, ascending

 private:
  void Damaged(const std::string& what);

  Database& database_;
  Statement birth_;
  Statement results_;
  Statement simulation_;
  Statement evidence_;
  Statement fitnesses_;
  Statement generation_;
  Statement members_;
};

}  // namespace plsc
