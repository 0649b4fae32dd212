#pragma once

// A run on the disk: one SQLite file that holds what the run is a function of
// and all that came of it (docs/runs.md has the tables). Written while the run
// goes on, so that a kill at any instant loses nothing that was committed;
// read by `plsc evolve --resume`, show, replay and export, and by any tool that
// speaks SQL, also meanwhile. The same run leaves the same result tables, bit
// for bit, whatever the order in which evaluations arrive.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grammar/expected.h"
#include "grammar/failure.h"
#include "runtime/evolve/experiment.h"
#include "runtime/evolve/run_observer.h"
#include "runtime/evolve/saved_run.h"
#include "runtime/evolve/simulation_cache.h"
#include "runtime/life/simulated.h"
#include "runtime/store/census.h"
#include "runtime/store/session.h"
#include "runtime/store/trial_rows.h"
#include "runtime/store/versions.h"

namespace plsc {

/// How far a run is.
struct RunStatus {
  int generations = 0;           ///< completed, the initial one included
  std::int64_t evaluations = 0;  ///< done
  int best = 0;  ///< id, of the last completed generation; 0: there is none
  bool is_finished = false;  ///< all generations of the experiment
};

/// An individual of somebody's lineage.
struct Ancestor {
  int distance = 0;  ///< births between the two; 0 is who was asked about
  int id = 0;
  int generation = 0;
  Heritage heritage;
  SeasonFitnesses fitnesses;  ///< empty if it was not evaluated yet
};

/// Failures are messages for the user, ready to be printed behind "error: ".
/// Not to be used on both sides of a fork: a copy in a child does nothing.
class RunStore : public RunObserver, public SimulationCache {
 public:
  RunStore();
  ~RunStore() override;
  RunStore(const RunStore&) = delete;
  RunStore& operator=(const RunStore&) = delete;

  /// What would keep Create from it, as far as can be told without making it.
  static MaybeFailure CheckCreate(const std::string& path);
  /// Makes the file, which must not exist, for writing. `versions` default to
  /// those of this program; others are for tests.
  MaybeFailure Create(const std::string& path, const Experiment& experiment,
                      const std::optional<Versions>& versions = std::nullopt);
  /// For going on with a run: everything is checked first, and a store that is
  /// damaged, or that another process works on, is refused unchanged. So is
  /// one that another program or kind of machine began, unless `any_version`:
  /// its results may then be those of no single program. A store of an older
  /// schema is never gone on with: it has no place for all there is to write.
  MaybeFailure Open(const std::string& path, bool any_version = false);
  /// Changes nothing, and works while another process writes. What the run is
  /// must be what was written; robots and generations are compared with their
  /// checksums when they are read, and fail then.
  MaybeFailure OpenForReading(const std::string& path);
  /// Ends the work on it; the only way to learn that the last writes failed.
  /// The destructor does the same in silence.
  MaybeFailure Close();
  /// Ends the work on it as if it had never begun: what Create made is deleted.
  void Discard();
  /// The file was deleted, moved or replaced while it was written to, which
  /// the next On... and Close say; what they wrote is not in `path`.
  bool is_lost() const;

  const std::string& path() const;
  const Experiment& experiment() const;
  /// Of the program that created it.
  const Versions& versions() const;
  /// Of the file (schema.h); an older one lacks MissingMeasures.
  int schema() const;

  /// All of this is empty in a run that was created and left at once. Those of
  /// the generation under way whose workers died are as not evaluated yet:
  /// OnEvaluated replaces them.
  Expected<SavedRun, Failure> Load();
  Expected<RunStatus, Failure> Status();
  /// With its evaluation, if it has one, every field as it was, bit for bit
  /// (but that -0 became 0).
  Expected<Individual, Failure> Find(int id);
  /// As Find, but of its first life alone: what disturbed it, and its own
  /// fitness and outcome, in place of those over all trials. This is the life
  /// that EvidenceOf is of.
  Expected<Individual, Failure> FindFirstLife(int id);
  /// By season and trial; empty in runs without trials and noise.
  Expected<std::vector<std::vector<StoredTrial>>, Failure> TrialsOf(int id);
  /// Which run it is: under its experiment, constants and versions, of which
  /// all else is a function.
  Expected<std::int64_t, Failure> ChecksumOfRun();
  /// Of an individual's birth, with its genotype.
  Expected<std::int64_t, Failure> ChecksumOfBirth(int id);
  /// Individuals, from id 1 to this.
  Expected<int, Failure> Born();
  Expected<GenerationRecord, Failure> Generation(int number);
  /// Of all completed generations. Not compared with checksums.
  Expected<std::vector<CensusCounts>, Failure> Censuses();
  /// Everybody who was evaluated, in order of id.
  Expected<std::vector<int>, Failure> EvaluatedIds();
  /// Those behind Find(id).evaluation: keys, body and brain.
  Expected<std::vector<SeasonEvidence>, Failure> EvidenceOf(int id);
  /// `id` itself, its parents, theirs ... up to `distance` births away: by
  /// distance, then by id, everybody once.
  Expected<std::vector<Ancestor>, Failure> Lineage(int id, int distance);

  /// A row of the table `session`, until EndSession as one that was killed.
  MaybeFailure BeginSession(const SessionStart& start);
  MaybeFailure EndSession(const SessionEnd& end);

  MaybeFailure OnBirths(const std::vector<Individual>& born,
                        const std::function<bool()>& should_stop) override;
  MaybeFailure OnEvaluated(
      const Individual& one,
      const std::vector<SeasonEvidence>& evidence) override;
  MaybeFailure OnGeneration(const GenerationRecord& record) override;

  /// Never one whose worker died, nor of a store that cannot be read.
  std::optional<Simulated> Find(const Key& key) override;
  /// Nothing: OnEvaluated has what there is to store.
  MaybeFailure Add(const Key& key, const Simulated& simulated) override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace plsc
