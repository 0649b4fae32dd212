// A row a season of a life, whole or not there: those of one life are added in
// one transaction. Nothing says what was asked for, only what was lived, so a
// file that was stopped at any instant, and one that more is asked of, are the
// same case. No clock and no process are in it: the same lives make the same
// rows, whoever lived them and in which order.
//
// As of runs, a checksum is made of what the database gives back (-0 is 0
// there), SQLite's own finding only damage to its structure.

#include "runtime/relive/relived_file.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "runtime/develop/descriptors.h"
#include "runtime/relive/displacement.h"
#include "runtime/store/database.h"
#include "runtime/store/lock.h"
#include "runtime/store/make_database.h"
#include "runtime/store/names.h"
#include "runtime/store/schema.h"
#include "runtime/store/schema_check.h"
#include "runtime/text/key.h"

namespace plsc {

namespace {

namespace fs = std::filesystem;

constexpr int kRelivedFormat = 1;
constexpr std::string_view kEnd = ".relived.sqlite";

constexpr const char* kRelived = R"sql(CREATE TABLE relived(
  id INTEGER PRIMARY KEY CHECK (id = 1),
  name TEXT NOT NULL,  -- of the run
  seed TEXT NOT NULL,  -- of the run
  run INTEGER NOT NULL,  -- checksum of the run's row and constants
  most_lift REAL NOT NULL))sql";  // m

constexpr const char* kProgram = R"sql(CREATE TABLE program(
  engine TEXT PRIMARY KEY,  -- 'own' or 'other', as in life: who lived these
  plsc TEXT NOT NULL,
  ode TEXT NOT NULL,
  compiler TEXT NOT NULL,
  machine TEXT NOT NULL,
  results INTEGER NOT NULL) WITHOUT ROWID)sql";

constexpr const char* kSeason = R"sql(CREATE TABLE season(
  id INTEGER PRIMARY KEY,  -- from 1, as in the run
  name TEXT NOT NULL UNIQUE))sql";

constexpr const char* kRobot = R"sql(CREATE TABLE robot(
  individual INTEGER PRIMARY KEY,  -- of the run
  checksum INTEGER NOT NULL))sql";  // the run's, of its birth

constexpr const char* kLife = R"sql(CREATE TABLE life(
  individual INTEGER NOT NULL REFERENCES robot,
  engine TEXT NOT NULL REFERENCES program,  -- 'own': the run's; 'other'
  season INTEGER NOT NULL REFERENCES season,  -- on whose ground
  phenotype INTEGER NOT NULL REFERENCES season,  -- with whose body and brain
  n INTEGER NOT NULL,  -- from 1
  lift REAL NOT NULL,  -- m, that the start was higher
  outcome TEXT NOT NULL,
  reason TEXT NOT NULL,
  is_valid INTEGER NOT NULL,  -- whether it behaved; else these are NULL:
{}  fitness REAL,  -- m/s; NULL is worse than any number
  state_hash TEXT NOT NULL,
  steps INTEGER NOT NULL,
  solver_warnings INTEGER NOT NULL,
  checksum INTEGER NOT NULL,
  PRIMARY KEY (individual, engine, season, phenotype, n)) WITHOUT ROWID)sql";

/// Columns of behaviour: RelivedMeasures without fitness, which has its own.
std::vector<std::string> MeasureColumns() {
  std::vector<std::string> names = RelivedMeasures();
  names.erase(names.begin());
  return names;
}

std::vector<SchemaItem> MakeTables() {
  std::string measures;
  for (const std::string& name : MeasureColumns())
    measures += fmt::format("  {} REAL,\n", name);
  const auto table = [](const char* name, std::string sql) {
    return SchemaItem{name, std::move(sql), SchemaKind::kTable, true, ""};
  };
  return {table("relived", kRelived), table("program", kProgram),
          table("season", kSeason), table("robot", kRobot),
          table("life", fmt::format(kLife, measures))};
}

const std::vector<SchemaItem>& RelivedTables() {
  static const std::vector<SchemaItem> tables = MakeTables();
  return tables;
}

void AddRelivedTables(Database& database, const RunIdentity& run) {
  database.Run(
      fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}",
                  kRelivedApplicationId, kRelivedFormat));
  for (const SchemaItem& table : RelivedTables()) database.Run(table.sql);
  Statement(database, "INSERT INTO relived VALUES(1, ?, ?, ?, ?)")
      .With(run.name, run.seed, run.checksum, kMostLift)
      .Run();
  Statement season(database, "INSERT INTO season VALUES(?, ?)");
  int id = 0;
  for (const std::string& name : run.seasons) season.With(++id, name).Run();
}

const char* EngineText(bool is_other_engine) {
  return is_other_engine ? "other" : "own";
}

double Stored(double value) {
  return value == 0 ? 0 : value;
}

std::int64_t SumOf(const RelivedSeason& life) {
  std::string bytes = fmt::format(
      "{} {} {} {} {} {} {} {} {:016x} {} {}", life.of.id,
      EngineText(life.of.is_other_engine), life.of.season, life.of.phenotype,
      life.n, OutcomeName(life.outcome), life.reason.size(), life.reason,
      life.state_hash, life.steps, life.solver_warnings);
  const auto add = [&](double value) {
    const auto words =
        std::bit_cast<std::array<char, sizeof value>>(Stored(value));
    bytes.append(words.data(), words.size());
  };
  add(life.lift);
  for (const auto& value : MeasuresOf(life.behaviour, life.fitness)) {
    bytes += value ? '1' : '0';
    if (value) add(*value);
  }
  return static_cast<std::int64_t>(KeyOf(bytes).low);
}

std::string InsertSql() {
  std::string marks;
  for (std::size_t i = 0; i < MeasureColumns().size(); ++i) marks += "?, ";
  return fmt::format(
      "INSERT OR REPLACE INTO life VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, {}"
      "?, ?, ?, ?, ?)",
      marks);
}

std::string SelectSql() {
  return fmt::format(
      "SELECT individual, engine, season, phenotype, n, lift, outcome, reason, "
      "is_valid, {}, fitness, state_hash, steps, solver_warnings, checksum "
      "FROM life ORDER BY individual, engine = 'other', season, phenotype, n",
      fmt::join(MeasureColumns(), ", "));
}

/// Nothing of a row that is not what was written.
std::optional<RelivedSeason> TakeLife(Statement& row, int seasons) {
  RelivedSeason life;
  life.of.id = row.TakeInt();
  const std::string engine = row.TakeText();
  life.of.is_other_engine = engine == EngineText(true);
  life.of.season = row.TakeInt() - 1;
  life.of.phenotype = row.TakeInt() - 1;
  life.n = row.TakeInt();
  life.lift = row.TakeReal();
  const auto outcome = ValueIn(kOutcomeNames, row.TakeText());
  life.outcome = outcome.value_or(Outcome::kCompleted);
  life.reason = row.TakeText();
  const bool is_valid = row.TakeInteger() != 0;
  std::vector<double> values(List(Behaviour{}).size(),
                             std::numeric_limits<double>::quiet_NaN());
  const std::size_t kept = MeasureColumns().size();
  for (std::size_t i = 0; i < kept; ++i) values[i] = row.TakeReal();
  if (is_valid) life.behaviour = BehaviourOf(values);
  life.fitness = row.TakeOptional();
  const auto hash = WordOfHex(row.TakeText());
  life.state_hash = hash.value_or(0);
  life.steps = row.TakeInteger();
  life.solver_warnings = row.TakeInt();
  const auto is_season = [&](int i) { return i >= 0 && i < seasons; };
  if (!outcome || !hash || !is_season(life.of.season) ||
      !is_season(life.of.phenotype) || row.TakeInteger() != SumOf(life))
    return std::nullopt;
  return life;
}

std::string HowToBeginAnew(const std::string& path) {
  return fmt::format("delete '{}', or move it away, to begin anew", path);
}

}  // namespace

std::string RelivedPathOf(const std::string& run) {
  constexpr std::string_view kRunEnd = ".sqlite";
  const bool has_end = run.ends_with(kRunEnd);
  return (has_end ? run.substr(0, run.size() - kRunEnd.size()) : run) +
         std::string(kEnd);
}

bool IsRelivedFile(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;
  // https://www.sqlite.org/fileformat.html, 1.3: the application's number.
  constexpr std::size_t kPlace = 68;
  std::array<char, kPlace + 4> bytes{};
  std::ifstream file(path, std::ios::binary);
  const bool is_whole = !!file.read(bytes.data(), bytes.size());
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number = number << 8 | static_cast<unsigned char>(bytes[kPlace + i]);
  if (is_whole && number == kRelivedApplicationId) return true;
  return path.ends_with(kEnd) && !(is_whole && number == kApplicationId);
}

Expected<RunIdentity, Failure> IdentityOf(RunStore& store) {
  const Expected<std::int64_t, Failure> checksum = store.ChecksumOfRun();
  if (!checksum) return checksum.error();
  const Experiment& experiment = store.experiment();
  RunIdentity run{store.path(),
                  experiment.name,
                  std::to_string(experiment.seed),
                  *checksum,
                  {}};
  for (const Season& season : experiment.scenario.seasons)
    run.seasons.push_back(season.name);
  return run;
}

// In the order in which they must go.
struct RelivedFile::Parts {
  std::string path;
  std::size_t seasons = 0;
  RunLock lock;
  Database database;
  std::unique_ptr<Statement> insert;

  MaybeFailure CheckFormat() {
    const std::int64_t application =
        SingleInteger(database, "PRAGMA application_id");
    const std::int64_t format = SingleInteger(database, "PRAGMA user_version");
    if (database.has_failed()) return database.TakeFailure();
    if (application != kRelivedApplicationId)
      return fmt::format(
          "'{}' is not of lives that were lived again (plsc relive): move it "
          "away",
          path);
    if (format > kRelivedFormat)
      return fmt::format(
          "'{}' was made by a newer plsc (its format is {}, this program knows "
          "{}): use that one",
          path, format, kRelivedFormat);
    if (format < kRelivedFormat)
      return fmt::format(
          "'{}' has format {}, which this program does not read: {}", path,
          format, HowToBeginAnew(path));
    return std::nullopt;
  }

  MaybeFailure CheckRun(const RunIdentity& run) {
    Statement row(database, "SELECT run, seed FROM relived");
    const bool is_there = row.With().Next();
    const std::int64_t checksum = is_there ? row.TakeInteger() : 0;
    if (MaybeFailure failure = database.TakeFailure()) return failure;
    if (!is_there)
      return fmt::format("'{}' is damaged: it does not say of which run it is",
                         path);
    if (checksum == run.checksum) return std::nullopt;
    return fmt::format("'{}' is of another run than '{}': {}", path, run.path,
                       HowToBeginAnew(path));
  }
};

RelivedFile::RelivedFile() : parts_(std::make_unique<Parts>()) {}

RelivedFile::~RelivedFile() {
  Close();
}

MaybeFailure RelivedFile::Connect(const std::string& path, bool is_writing,
                                  const RunIdentity& run) {
  Parts& parts = *parts_;
  parts.path = path;
  parts.seasons = run.seasons.size();
  if (MaybeFailure failure = parts.database.Open(
          path, is_writing ? Database::Mode::kWrite : Database::Mode::kRead))
    return failure;
  if (MaybeFailure failure = parts.CheckFormat()) return failure;
  if (MaybeFailure failure = CheckNothingAdded(parts.database, RelivedTables()))
    return failure;
  if (MaybeFailure failure = parts.CheckRun(run)) return failure;
  if (is_writing)
    parts.insert = std::make_unique<Statement>(parts.database, InsertSql());
  return parts.database.TakeFailure();
}

MaybeFailure RelivedFile::OpenForReading(const std::string& path,
                                         const RunIdentity& run) {
  parts_ = std::make_unique<Parts>();
  return Connect(path, false, run);
}

MaybeFailure RelivedFile::OpenForWriting(const std::string& path,
                                         const RunIdentity& run) {
  parts_ = std::make_unique<Parts>();
  std::error_code error;
  MaybeFailure failure;
  if (fs::exists(fs::symlink_status(path, error))) {
    failure = parts_->lock.Take(path);
  } else {
    failure = MakeDatabase(
        path, [&](Database& database) { AddRelivedTables(database, run); },
        [&](int descriptor) { return parts_->lock.TakeNew(path, descriptor); });
    // Another process may have made it meanwhile.
    if (failure && fs::exists(path, error)) failure = parts_->lock.Take(path);
  }
  if (!failure) failure = Connect(path, true, run);
  if (failure) parts_ = std::make_unique<Parts>();
  return failure;
}

MaybeFailure RelivedFile::BeginEngine(bool is_other_engine,
                                      const Versions& versions) {
  Database& database = parts_->database;
  Transaction all(database);
  Statement row(database,
                "SELECT plsc, ode, compiler, machine, results FROM program "
                "WHERE engine = ?");
  if (row.With(EngineText(is_other_engine)).Next()) {
    Versions before;
    before.plsc = row.TakeText();
    before.ode = row.TakeText();
    before.compiler = row.TakeText();
    before.machine = row.TakeText();
    before.results = row.TakeInt();
    row.Run();
    if (database.has_failed()) return database.TakeFailure();
    if (MakeTheSame(before, versions)) return std::nullopt;
    return fmt::format(
        "the lives in '{}' were lived by plsc {} (results {}), and those of "
        "this one would differ: {}",
        parts_->path, before.plsc, before.results,
        HowToBeginAnew(parts_->path));
  }
  Statement(database, "INSERT INTO program VALUES(?, ?, ?, ?, ?, ?)")
      .With(EngineText(is_other_engine), versions.plsc, versions.ode,
            versions.compiler, versions.machine, versions.results)
      .Run();
  return all.Commit();
}

MaybeFailure RelivedFile::CheckRobots(const RobotSums& robots) {
  Database& database = parts_->database;
  Statement row(database, "SELECT individual, checksum FROM robot");
  for (row.With(); row.Next();) {
    const int id = row.TakeInt();
    const std::int64_t checksum = row.TakeInteger();
    const auto known = robots.find(id);
    if (known != robots.end() && known->second != checksum)
      database.Fail(
          fmt::format("'{}' is of another run: robot {} is another "
                      "there; {}",
                      parts_->path, id, HowToBeginAnew(parts_->path)));
  }
  return database.TakeFailure();
}

MaybeFailure RelivedFile::BeginRobots(const RobotSums& robots) {
  if (MaybeFailure failure = CheckRobots(robots)) return failure;
  Transaction all(parts_->database);
  Statement insert(parts_->database,
                   "INSERT OR IGNORE INTO robot VALUES(?, ?)");
  for (const auto& [id, checksum] : robots) insert.With(id, checksum).Run();
  return all.Commit();
}

Expected<std::vector<RelivedSeason>, Failure> RelivedFile::Lives() {
  Database& database = parts_->database;
  std::vector<RelivedSeason> lives;
  Statement row(database, SelectSql());
  for (row.With(); row.Next();) {
    std::optional<RelivedSeason> life =
        TakeLife(row, static_cast<int>(parts_->seasons));
    if (!life)
      database.Fail(
          fmt::format("'{}' is damaged: a life is not what was written; {}",
                      parts_->path, HowToBeginAnew(parts_->path)));
    else
      lives.push_back(std::move(*life));
  }
  if (MaybeFailure failure = database.TakeFailure()) return std::move(*failure);
  return lives;
}

MaybeFailure RelivedFile::Add(const std::vector<RelivedSeason>& lives) {
  Database& database = parts_->database;
  if (MaybeFailure failure = database.CheckInPlace()) return failure;
  Transaction all(database);
  for (const RelivedSeason& life : lives) {
    const std::string hash = fmt::format("{:016x}", life.state_hash);
    Statement& row = parts_->insert->With(
        life.of.id, EngineText(life.of.is_other_engine), life.of.season + 1,
        life.of.phenotype + 1, life.n, life.lift, OutcomeName(life.outcome),
        life.reason, life.behaviour.is_valid ? 1 : 0);
    const std::vector<NamedValue> values = List(life.behaviour);
    for (std::size_t i = 0; i + 1 < RelivedMeasures().size(); ++i)
      row.And(life.behaviour.is_valid ? std::optional(values[i].value)
                                      : std::nullopt);
    row.And(life.fitness)
        .And(hash)
        .And(life.steps)
        .And(life.solver_warnings)
        .And(SumOf(life))
        .Run();
  }
  return all.Commit();
}

MaybeFailure RelivedFile::Close() {
  Parts& parts = *parts_;
  MaybeFailure failure = parts.database.TakeFailure();
  // The journal goes into the file now, so that the file alone is all.
  if (parts.insert && !failure && parts.database.is_own()) {
    parts.database.Run("PRAGMA wal_checkpoint(PASSIVE)");
    failure = parts.database.TakeFailure();
    if (MaybeFailure lost = parts.database.CheckInPlace()) failure = lost;
  }
  parts.insert.reset();
  parts.database.Close();
  parts.lock.Release();
  return failure;
}

}  // namespace plsc
