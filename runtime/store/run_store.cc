// A run's file from the outside: made, opened, read, left. Two rules run
// through it. Nothing is written to a file before everything in it has been
// examined under the lock (Open looks, locks, examines, and only then connects
// for writing), because a run that goes on from a damaged generation cannot be
// told from a good one later. And before every transaction the file is asked
// whether it still is the file of its name: a store that was deleted or
// replaced while the run goes on would take results that nobody ever finds.
//
// Answers of several queries are of one instant (Transaction), as another
// process may be writing. A worker's death that nothing was selected by yet is
// forgotten when a run goes on, so that bad luck of one evening does not stay
// in its results.
//
// At the end the journal is moved into the file, so that the file alone is the
// run; whoever reads for long is not waited for.

#include "runtime/store/run_store.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "runtime/life/simulated.h"
#include "runtime/store/companions.h"
#include "runtime/store/create.h"
#include "runtime/store/database.h"
#include "runtime/store/lock.h"
#include "runtime/store/row_checks.h"
#include "runtime/store/run_reader.h"
#include "runtime/store/run_writer.h"
#include "runtime/store/schema.h"
#include "runtime/store/schema_check.h"
#include "runtime/store/verify.h"
#include "runtime/text/system_reason.h"

namespace plsc {

namespace {

std::string HostName() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return "";
  return name.data();
}

MaybeFailure CheckAbsent(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::symlink_status(path, error);
  if (std::filesystem::exists(status))
    return fmt::format(
        "'{}' exists; a run is never overwritten: choose another name, or go "
        "on with --resume",
        path);
  const auto folder = std::filesystem::path(path).parent_path();
  if (access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0)
    return fmt::format("cannot create '{}': {}", path, SystemReason(errno));
  return CheckNoCompanions(path);
}

std::map<std::string, int> SeasonIds(const Experiment& experiment) {
  std::map<std::string, int> ids;
  for (const Season& season : experiment.scenario.seasons)
    ids.emplace(season.name, static_cast<int>(ids.size()) + 1);
  return ids;
}

/// Why a store of this schema is not written to, or nothing.
MaybeFailure CheckCanGrow(const std::string& path, int schema,
                          const Versions& versions) {
  if (schema == kSchemaVersion) return std::nullopt;
  const auto missing = MissingMeasures(schema);
  return fmt::format(
      "'{}' is a store of schema {}, and this program's have {}: its lives "
      "lack "
      "{}, which cannot be added to them any more, so it can be read only; the "
      "program that began it (plsc {}) goes on with it",
      path, schema, kSchemaVersion, fmt::join(missing, ", "), versions.plsc);
}

bool HasDied(const Evaluation& evaluation) {
  return std::any_of(evaluation.seasons.begin(), evaluation.seasons.end(),
                     [](const SeasonResult& season) {
                       return season.outcome == Outcome::kWorkerDied;
                     });
}

}  // namespace

// In the order in which they must go: statements before their connection, and
// that before the lock.
struct RunStore::Parts {
  std::string path;
  Experiment experiment;
  Versions versions;
  int schema = 0;
  RunLock lock;
  Database database;
  std::unique_ptr<RunReader> reader;
  std::unique_ptr<TrialRows> trials;
  std::unique_ptr<RowChecks> checks;
  std::unique_ptr<RunWriter> writer;
  std::int64_t session = 0;  // its row
  bool is_new = false;       // made by this object
  bool is_lost = false;      // not where it was any more

  MaybeFailure Connect(Database::Mode mode);
  MaybeFailure ReadRun();
  /// That what is written goes into the file of this name.
  MaybeFailure CheckInPlace();
  /// Of everything since the last failure that was reported.
  template <typename T>
  Expected<T, Failure> OrFailure(T value) {
    if (MaybeFailure failure = database.TakeFailure())
      return std::move(*failure);
    return value;
  }
  std::vector<Ancestor> FindLineage(int id, int distance);
};

MaybeFailure RunStore::Parts::Connect(Database::Mode mode) {
  if (MaybeFailure failure = database.Open(path, mode)) return failure;
  if (MaybeFailure failure = CheckIdentity(database)) return failure;
  schema = SchemaOf(database);
  if (mode != Database::Mode::kRead)
    if (MaybeFailure failure = CheckNothingAdded(database, Schema(schema)))
      return failure;
  if (MaybeFailure failure = ReadRun()) return failure;
  reader = std::make_unique<RunReader>(database);
  trials = std::make_unique<TrialRows>(database);
  checks = std::make_unique<RowChecks>(database);
  if (mode != Database::Mode::kRead)
    writer = std::make_unique<RunWriter>(database, *reader, experiment,
                                         SeasonIds(experiment));
  return database.TakeFailure();
}

MaybeFailure RunStore::Parts::CheckInPlace() {
  MaybeFailure failure = database.CheckInPlace();
  is_lost = is_lost || failure;
  return failure;
}

MaybeFailure RunStore::Parts::ReadRun() {
  Statement run(database,
                "SELECT plsc, ode, compiler, machine, results, experiment "
                "FROM run");
  if (!run.With().Next()) {
    if (MaybeFailure failure = database.TakeFailure()) return failure;
    return fmt::format("'{}' is damaged: it does not say what the run is",
                       path);
  }
  versions.plsc = run.TakeText();
  versions.ode = run.TakeText();
  versions.compiler = run.TakeText();
  versions.machine = run.TakeText();
  versions.results = run.TakeInt();
  Result<Experiment> read = ParseExperiment(Source(path, run.TakeText()));
  if (!read)
    return fmt::format("'{}' is damaged: its experiment cannot be read ({})",
                       path, read.diagnostics().front().message);
  experiment = std::move(*read);
  return database.TakeFailure();
}

RunStore::RunStore() : parts_(std::make_unique<Parts>()) {}

RunStore::~RunStore() {
  Close();
}

MaybeFailure RunStore::Create(const std::string& path,
                              const Experiment& experiment,
                              const std::optional<Versions>& versions) {
  parts_ = std::make_unique<Parts>();
  parts_->path = path;
  if (MaybeFailure failure = CheckAbsent(path)) return failure;
  MaybeFailure failure = CreateStoreFile(
      path, experiment, versions.value_or(VersionsFor(experiment.scenario)),
      parts_->lock);
  // Another process may have made it since we looked.
  if (failure)
    if (MaybeFailure exists = CheckAbsent(path)) failure = std::move(exists);
  parts_->is_new = !failure;
  if (!failure) failure = parts_->Connect(Database::Mode::kWrite);
  if (failure) Discard();
  return failure;
}

MaybeFailure RunStore::CheckCreate(const std::string& path) {
  return CheckAbsent(path);
}

MaybeFailure RunStore::Open(const std::string& path, bool any_version) {
  parts_ = std::make_unique<Parts>();
  parts_->path = path;
  // What is no file at all is not worth a lock.
  MaybeFailure failure = parts_->Connect(Database::Mode::kRead);
  const Versions versions = parts_->versions;
  const int schema = parts_->schema;
  parts_ = std::make_unique<Parts>();
  parts_->path = path;
  if (!failure) failure = parts_->lock.Take(path);
  if (!failure && !any_version) failure = CheckVersions(path, versions);
  if (!failure) failure = CheckCanGrow(path, schema, versions);
  if (!failure) failure = Examine(path).problem;
  if (!failure) failure = parts_->Connect(Database::Mode::kWrite);
  if (failure) parts_ = std::make_unique<Parts>();
  return failure;
}

MaybeFailure RunStore::OpenForReading(const std::string& path) {
  parts_ = std::make_unique<Parts>();
  parts_->path = path;
  MaybeFailure failure = parts_->Connect(Database::Mode::kRead);
  if (!failure) failure = parts_->checks->Run();
  if (failure) parts_ = std::make_unique<Parts>();
  return failure;
}

void RunStore::Discard() {
  Parts& parts = *parts_;
  parts.writer.reset();
  parts.checks.reset();
  parts.trials.reset();
  parts.reader.reset();
  parts.database.Close();
  if (parts.is_new && parts.lock.IsOn(parts.path))
    for (const char* end : {"", "-wal", "-shm"})
      unlink((parts.path + end).c_str());
  parts_ = std::make_unique<Parts>();
}

MaybeFailure RunStore::Close() {
  Parts& parts = *parts_;
  MaybeFailure failure = parts.database.TakeFailure();
  // The journal goes into the file now and not at some later opening, so that
  // the file alone is the run.
  if (parts.writer && !failure && parts.database.is_own()) {
    // Passive: whoever reads for long is not waited for.
    parts.database.Run("PRAGMA wal_checkpoint(PASSIVE)");
    failure = parts.database.TakeFailure();
    if (MaybeFailure lost = parts.CheckInPlace()) failure = std::move(lost);
  }
  parts.writer.reset();
  parts.checks.reset();
  parts.trials.reset();
  parts.reader.reset();
  parts.database.Close();
  parts.lock.Release();
  return failure;
}

bool RunStore::is_lost() const {
  return parts_->is_lost;
}

const std::string& RunStore::path() const {
  return parts_->path;
}

const Experiment& RunStore::experiment() const {
  return parts_->experiment;
}

const Versions& RunStore::versions() const {
  return parts_->versions;
}

int RunStore::schema() const {
  return parts_->schema;
}

Expected<SavedRun, Failure> RunStore::Load() {
  assert(parts_->reader);
  RunReader& reader = *parts_->reader;
  const Transaction instant(parts_->database);
  SavedRun saved;
  saved.generations = reader.Generations();
  saved.evaluations = reader.Evaluations();
  int next = 1;  // the first id of the generation under way
  if (saved.generations > 0) {
    const auto last = reader.FindGeneration(saved.generations - 1);
    if (!last || last->pool.empty()) {
      parts_->database.Fail(fmt::format(
          "'{}' is damaged: its last generation cannot be read", path()));
      return parts_->OrFailure(saved);
    }
    std::map<int, int> counts;  // by id
    for (std::size_t i = 0; i < last->pool.size(); ++i)
      counts[last->pool[i]] = last->counts[i];
    for (const int id : last->survivors) {
      saved.population.push_back(reader.FindIndividual(id));
      saved.counts.push_back(counts[id]);
    }
    next = *std::max_element(last->pool.begin(), last->pool.end()) + 1;
  }
  for (const int id : reader.EvaluatedSince(next)) {
    Evaluation evaluation = reader.FindEvaluation(id);
    // Nothing was selected by its death yet, so it is as if it never was.
    if (HasDied(evaluation))
      --saved.evaluations;
    else
      saved.evaluated.emplace(id, std::move(evaluation));
  }
  return parts_->OrFailure(std::move(saved));
}

Expected<RunStatus, Failure> RunStore::Status() {
  assert(parts_->reader);
  RunReader& reader = *parts_->reader;
  const Transaction instant(parts_->database);
  RunStatus status;
  if (MaybeFailure failure = parts_->checks->Completed(experiment()))
    return *failure;
  status.generations = reader.Generations();
  if (status.generations > 0)
    if (MaybeFailure failure =
            parts_->checks->Generation(status.generations - 1))
      return *failure;
  status.evaluations = reader.Evaluations();
  if (status.generations > 0)
    if (const auto last = reader.FindGeneration(status.generations - 1))
      status.best = last->best;
  status.is_finished = status.generations == experiment().generations;
  return parts_->OrFailure(status);
}

Expected<Individual, Failure> RunStore::Find(int id) {
  assert(parts_->reader);
  const Transaction instant(parts_->database);
  if (MaybeFailure failure = parts_->checks->Robot(experiment(), id))
    return *failure;
  return parts_->OrFailure(parts_->reader->FindIndividual(id));
}

Expected<Individual, Failure> RunStore::FindFirstLife(int id) {
  Expected<Individual, Failure> one = Find(id);
  if (!one) return one;
  const auto trials = parts_->trials->Find(id);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    SeasonResult& season = one->evaluation.seasons.at(i);
    const StoredTrial& first = trials[i].front();
    one->disturbances.push_back(first.disturbance);
    // Of a death there is nothing but that.
    if (season.outcome == Outcome::kWorkerDied) continue;
    season.outcome = first.outcome;
    season.reason = first.reason;
    season.fitness = first.fitness;
  }
  return parts_->OrFailure(std::move(*one));
}

Expected<std::vector<std::vector<StoredTrial>>, Failure> RunStore::TrialsOf(
    int id) {
  assert(parts_->reader);
  const Transaction instant(parts_->database);
  if (MaybeFailure failure = parts_->checks->Robot(experiment(), id))
    return *failure;
  return parts_->OrFailure(parts_->trials->Find(id));
}

Expected<std::int64_t, Failure> RunStore::ChecksumOfRun() {
  assert(parts_->reader);
  return parts_->OrFailure(
      SingleInteger(parts_->database, "SELECT checksum FROM run"));
}

Expected<std::int64_t, Failure> RunStore::ChecksumOfBirth(int id) {
  assert(parts_->reader);
  Statement row(parts_->database,
                "SELECT checksum FROM individual WHERE id = ?");
  return parts_->OrFailure(row.With(id).Next() ? row.TakeInteger() : 0);
}

Expected<int, Failure> RunStore::Born() {
  assert(parts_->reader);
  Statement last(parts_->database, "SELECT max(id) FROM individual");
  return parts_->OrFailure(last.With().Next() ? last.TakeInt() : 0);
}

Expected<GenerationRecord, Failure> RunStore::Generation(int number) {
  assert(parts_->reader);
  const Transaction instant(parts_->database);
  if (MaybeFailure failure = parts_->checks->Completed(experiment()))
    return *failure;
  if (number < 0 || number >= parts_->reader->Generations())
    return Failure(fmt::format("'{}' has no generation {}", path(), number));
  if (MaybeFailure failure = parts_->checks->Generation(number))
    return *failure;
  auto record = parts_->reader->FindGeneration(number);
  return parts_->OrFailure(std::move(record).value_or(GenerationRecord{}));
}

Expected<std::vector<CensusCounts>, Failure> RunStore::Censuses() {
  assert(parts_->reader);
  const Transaction instant(parts_->database);
  return parts_->OrFailure(CensusOf(parts_->database, experiment()));
}

Expected<std::vector<int>, Failure> RunStore::EvaluatedIds() {
  assert(parts_->reader);
  const Transaction instant(parts_->database);
  std::vector<int> ids;
  Statement evaluated(parts_->database,
                      "SELECT DISTINCT individual FROM evaluation ORDER BY 1");
  for (evaluated.With(); evaluated.Next();) ids.push_back(evaluated.TakeInt());
  return parts_->OrFailure(ids);
}

Expected<std::vector<SeasonEvidence>, Failure> RunStore::EvidenceOf(int id) {
  assert(parts_->reader);
  const Transaction instant(parts_->database);
  if (MaybeFailure failure = parts_->checks->Robot(experiment(), id))
    return *failure;
  return parts_->OrFailure(parts_->reader->FindEvidence(id));
}

std::vector<Ancestor> RunStore::Parts::FindLineage(int id, int distance) {
  const Transaction instant(database);
  std::vector<Ancestor> lineage;
  std::set<int> seen = {id};
  std::set<int> level = {id};
  for (int d = 0; d <= distance && !level.empty(); ++d) {
    std::set<int> parents;
    for (const int one : level) {
      MaybeFailure failure = checks->Robot(experiment, one);
      std::optional<Birth> birth;
      if (!failure) birth = reader->FindBirth(one);
      if (!birth) {
        if (failure) database.Fail(std::move(*failure));
        return lineage;
      }
      for (const int parent : birth->heritage.parents)
        if (seen.insert(parent).second) parents.insert(parent);
      lineage.push_back({d, one, birth->generation, std::move(birth->heritage),
                         reader->FindFitnesses(one)});
    }
    level = std::move(parents);
  }
  return lineage;
}

Expected<std::vector<Ancestor>, Failure> RunStore::Lineage(int id,
                                                           int distance) {
  assert(parts_->reader);
  return parts_->OrFailure(parts_->FindLineage(id, distance));
}

MaybeFailure RunStore::BeginSession(const SessionStart& start) {
  assert(parts_->writer);
  Database& database = parts_->database;
  const Versions versions = ThisProgram();
  Statement insert(database,
                   "INSERT INTO session(started, host, pid, plsc, ode, "
                   "compiler, machine, jobs) VALUES(?, ?, ?, ?, ?, ?, ?, ?)");
  insert
      .With(start.started, HostName(), getpid(), versions.plsc, versions.ode,
            versions.compiler, versions.machine, start.jobs)
      .Run();
  Statement row(database, "SELECT last_insert_rowid()");
  if (row.With().Next()) parts_->session = row.TakeInteger();
  return database.TakeFailure();
}

MaybeFailure RunStore::EndSession(const SessionEnd& end) {
  assert(parts_->writer);
  Statement update(parts_->database,
                   "UPDATE session SET ended = ?, how = ?, workers = ?, "
                   "evaluations = ?, simulated = ?, looked_up = ?, "
                   "seconds = ?, cpu_seconds = ? WHERE id = ?");
  update
      .With(end.ended, end.how, end.workers, end.evaluations, end.simulated,
            end.looked_up, end.seconds, end.cpu_seconds, parts_->session)
      .Run();
  return parts_->database.TakeFailure();
}

MaybeFailure RunStore::OnBirths(const std::vector<Individual>& born,
                                const std::function<bool()>& should_stop) {
  assert(parts_->writer);
  if (MaybeFailure failure = parts_->CheckInPlace()) return failure;
  return parts_->writer->Births(born, should_stop);
}

MaybeFailure RunStore::OnEvaluated(
    const Individual& one, const std::vector<SeasonEvidence>& evidence) {
  assert(parts_->writer);
  if (MaybeFailure failure = parts_->CheckInPlace()) return failure;
  return parts_->writer->Evaluated(one, evidence);
}

MaybeFailure RunStore::OnGeneration(const GenerationRecord& record) {
  assert(parts_->writer);
  if (MaybeFailure failure = parts_->CheckInPlace()) return failure;
  return parts_->writer->Completed(record);
}

std::optional<Simulated> RunStore::Find(const Key& key) {
  if (!parts_->reader) return std::nullopt;
  auto found = parts_->reader->FindSimulation(key);
  // What cannot be read is simulated again, and fails when it is written.
  if (parts_->database.TakeFailure()) return std::nullopt;
  return found;
}

MaybeFailure RunStore::Add(const Key&, const Simulated&) {
  return std::nullopt;
}

}  // namespace plsc
