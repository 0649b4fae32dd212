#pragma once

// The table `trial`: each life of a season that is lived several times, or
// disturbed. Runs without trials and noise have none of these rows, nor do
// stores before schema 4.

#include <optional>
#include <string>
#include <vector>

#include "runtime/life/life_plan.h"
#include "runtime/store/database.h"
#include "runtime/text/key.h"

namespace plsc {

/// One row; the keys are zero where there is no phenotype or simulation.
struct StoredTrial {
  Disturbance disturbance;
  Key phenotype;
  Key simulation;
  Outcome outcome = Outcome::kCompleted;
  std::string reason;
  std::optional<double> fitness;
};

class TrialRows {
 public:
  /// Of an older store, where the table is but a view, for reading only.
  explicit TrialRows(Database& database, bool is_writing = false);

  /// Phenotype and simulation are there already.
  void Add(int individual, int season, const std::vector<Trial>& trials);
  void Remove(int individual);
  /// By season, from the first; by trial. Empty if there are none. What cannot
  /// be read is a failure of the database.
  std::vector<std::vector<StoredTrial>> Find(int individual);

 private:
  Database& database_;
  Statement insert_;
  Statement remove_;
  Statement find_;
};

/// Whether a trial's simulation is stored: what a worker died of is none.
bool HasSimulation(const Trial& trial);

}  // namespace plsc
