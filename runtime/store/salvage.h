#pragma once

// What can still be used of a damaged run. A run is a function of its
// experiment, so it can always be made again; what takes the time, its
// simulations, is looked up in the damaged store wherever the checksums say
// that it is what was written. Changes nothing there.

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "grammar/failure.h"
#include "runtime/evolve/experiment.h"
#include "runtime/evolve/simulation_cache.h"
#include "runtime/life/simulated.h"
#include "runtime/store/run_store.h"

namespace plsc {

class RunReader;
struct StoredTrial;

class Salvage : public SimulationCache {
 public:
  /// Reads all there is. Why it is of no use at all, or nothing.
  MaybeFailure Open(const std::string& path);

  /// What the run is and who began it, if that can be trusted.
  const std::optional<Experiment>& experiment() const { return experiment_; }
  const Versions& versions() const { return versions_; }
  /// Of the file (schema.h). Where one lacks MissingMeasures no simulation can
  /// be used: a run would have them where it simulated only.
  int schema() const { return schema_; }
  /// Simulated seasons that can be used.
  std::size_t size() const { return known_.size(); }

  std::optional<Simulated> Find(const Key& key) override;
  /// Nothing: it is read only.
  MaybeFailure Add(const Key& key, const Simulated& simulated) override;

 private:
  void TakeTrials(const std::vector<StoredTrial>& trials, RunReader& reader);

  std::map<Key, Simulated> known_;
  std::optional<Experiment> experiment_;
  Versions versions_;
  int schema_ = 0;
};

}  // namespace plsc
