// Read while somebody may be writing. A store with a journal is read in one
// transaction, of one instant; one without is read as a file that stays as it
// is, and if it does not, all that was read is thrown away and read anew, now
// with a journal. Who works on it is asked first: a run that ends in between is
// then taken for running, which the next look corrects, and never for one that
// nobody works on.

#include "runtime/report/read_run.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "runtime/store/lock.h"
#include "runtime/store/verify.h"

namespace plsc {

namespace {

// A store without a journal is read as a file that stays as it is; when a
// process begins to write to it meanwhile, what was read is thrown away, and
// the next time there is a journal.
constexpr int kAttempts = 3;

/// Facts and population, of one instant.
MaybeFailure ReadTables(const std::string& path, const ReadOptions& options,
                        RunReading& reading) {
  Database database;
  if (MaybeFailure failure = database.Open(path, Database::Mode::kRead))
    return failure;
  if (MaybeFailure failure = CheckIdentity(database)) return failure;
  Transaction instant(database);
  reading.facts = ReadFacts(database);
  reading.population =
      SummarisePopulation(database, options.measures, options.with_spread);
  reading.population.censuses = CensusOf(database, reading.experiment);
  return instant.Commit();
}

bool HasClauses(const Experiment& experiment) {
  return experiment.genotype.encoding == Encoding::kPlasticoding;
}

/// What stays as it is once it is written.
MaybeFailure ReadRobots(RunStore& store, RunReading& reading) {
  if (reading.facts.best == 0) return std::nullopt;
  Expected<Portrait, Failure> best = PortraitOf(store, reading.facts.best);
  if (!best) return best.error();
  reading.best = std::move(*best);
  if (!HasClauses(store.experiment())) return std::nullopt;
  Expected<std::vector<RuleCount>, Failure> rules =
      CountRules(store, reading.population.survivors);
  if (!rules) return rules.error();
  reading.rules = std::move(*rules);
  return std::nullopt;
}

MaybeFailure ReadAll(const std::string& path, const ReadOptions& options,
                     const std::optional<Experiment>& expected,
                     RunReading& reading) {
  RunStore store;
  if (MaybeFailure failure = store.OpenForReading(path)) return failure;
  reading.experiment = store.experiment();
  if (expected && !AreSame(reading.experiment, *expected))
    return fmt::format(
        "'{}' is a run of another experiment or seed than the study's", path);
  if (options.verify)
    if (MaybeFailure failure = Examine(path).problem) return failure;
  if (MaybeFailure failure = ReadTables(path, options, reading)) return failure;
  return ReadRobots(store, reading);
}

}  // namespace

RunReading ReadRun(const std::string& path, const ReadOptions& options,
                   const std::optional<Experiment>& expected) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return {};
  MaybeFailure failure;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    // Asked first: a run that ends meanwhile is then taken for running, not
    // for one that nobody works on.
    const std::optional<std::string> worker = WhoWorksOn(path);
    RunReading reading;
    failure = ReadAll(path, options, expected, reading);
    if (!failure) {
      const bool is_done =
          reading.population.generations == reading.experiment.generations;
      reading.state = is_done  ? RunState::kDone
                      : worker ? RunState::kRunning
                               : RunState::kUnfinished;
      if (!is_done) reading.worker = worker.value_or("");
      return reading;
    }
    if (failure->kind != Failure::Kind::kChanged) break;
  }
  RunReading damaged;
  damaged.state = RunState::kDamaged;
  damaged.problem = std::move(failure->text);
  return damaged;
}

}  // namespace plsc
