#pragma once

// A run for a page that follows it: a row a generation, and each robot when it
// is asked for. Read from the store while another process writes it; what was
// read is kept, as generations that are completed do not change.

#include <map>
#include <optional>
#include <string>

#include "grammar/expected.h"
#include "grammar/failure.h"
#include "runtime/life/season_result.h"
#include "runtime/store/run_store.h"

namespace plsc::cli {

class RunFeed {
 public:
  explicit RunFeed(std::string path) : path_(std::move(path)) {}

  const std::string& path() const { return path_; }
  /// Reads on. Whether there is more than before; a failure once, until the
  /// store can be read again.
  Expected<bool, Failure> Look();

  /// An object (docs/live.md): name, seed, state, total_generations, seasons,
  /// scenario (YAML), generations: an array of generation, best (id), best_of
  /// (ids, by season), fitness (by season: best and median of the survivors,
  /// m/s or null), census (or null).
  std::string Json() const;
  /// {"generations", "state"}: what is in an event.
  std::string Summary() const;
  /// An object: id, generation, parents and how it came about, genotype, and
  /// its first parents back to generation 0, nearest first.
  Expected<std::string, Failure> Robot(int id) const;
  /// Of the last completed generation; 0: there is none.
  int best() const;
  /// YAML, of which all robots of the run lived; empty before a Look.
  const std::string& scenario() const { return scenario_; }

 private:
  struct Row {
    GenerationRecord record;
    std::vector<int> best_of;  ///< by season; 0: nobody completed it
    std::vector<std::optional<double>> best;
    std::vector<std::optional<double>> median;
  };

  MaybeFailure ReadRow(RunStore& store, int generation);

  std::string path_;
  std::string name_;
  std::string seed_;
  std::string scenario_;
  bool has_own_fitness_ = false;  ///< a formula's, and no speed
  std::vector<std::string> seasons_;
  int total_ = 0;
  std::string state_ = "missing";
  std::vector<Row> rows_;
  std::vector<CensusCounts> censuses_;
  std::map<int, SeasonFitnesses> fitnesses_;  ///< of the latest survivors
};

}  // namespace plsc::cli
