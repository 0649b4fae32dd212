// What can be trusted of a file, from the outside in. First whose file it is
// and of which schema: rows of another one must not be interpreted. Then what
// the run is (its experiment), because only from it follows which rows there
// must be: ids are numbered by generation (IdsBornIn), so that a missing row is
// found and not only a changed one. Then SQLite's own structure and references,
// and last every row against its checksum, generation by generation.
//
// Nothing stops at the first damage. `problem` says it, but the examination
// goes on, so that a user learns how many generations are whole and salvage
// what to use. `whole_generations` counts only as long as nothing was wrong: a
// run goes on from a generation only if all before it are as they were.
//
// Births of a generation are one transaction (run_writer), so of the one that
// is under way all are there or none; anything between is damage. A broken
// structure is the problem that is told, whatever else was found, since it
// explains the rest.
//
// A read of everything: about a second for 10,000 robots.

#include "runtime/store/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "runtime/evolve/experiment.h"
#include "runtime/store/row_checks.h"
#include "runtime/store/schema.h"

namespace plsc {

namespace {

std::string Damaged(const Database& database, const std::string& what) {
  return fmt::format("'{}' is damaged: {}", database.path(), what);
}

/// ", NULL AS a, NULL AS b".
std::string Nulls(const std::vector<std::string>& columns) {
  std::string text;
  for (const std::string& column : columns)
    text += fmt::format(", NULL AS {}", column);
  return text;
}

/// Of a store that has no trials: the table without a row.
void AddTrials(Database& database) {
  database.Run(
      "CREATE TEMP VIEW IF NOT EXISTS trial AS SELECT 0 AS individual, 0 AS "
      "season, 0 AS number, NULL AS phenotype, NULL AS simulation, '' AS "
      "outcome, '' AS reason, NULL AS fitness, 0 AS lift, 0 AS shift_x, 0 AS "
      "shift_y, 0 AS yaw, 0 AS friction, 0 AS lean, 0 AS touch, '' AS "
      "touch_seed, 0 AS motor, '' AS motor_seed WHERE 0");
}

/// What the older schema lacks is there for this connection, so that all
/// queries are of one schema; what it cannot be known any more is NULL. Nothing
/// of it gets into the file.
void AddWhatIsNew(Database& database, int version) {
  const auto add = [&](const char* table, const std::string& more) {
    database.Run(
        fmt::format("CREATE TEMP VIEW IF NOT EXISTS {0} AS "
                    "SELECT *{1} FROM main.{0}",
                    table, more));
  };
  if (version < 4) AddTrials(database);
  if (version < 2) add("run", ", 1 AS results");
  add("simulation", Nulls(MissingMeasures(version)));
  if (version < 3) add("generation", Nulls(CensusColumns()));
  // As it is, over these.
  for (const SchemaItem& item : Schema())
    if (item.name == "result")
      database.Run("CREATE TEMP VIEW IF NOT EXISTS" +
                   item.sql.substr(std::string("CREATE VIEW").size()));
}

bool HasSchema(Database& database) {
  std::map<std::string, std::string> found;
  Statement statement(database,
                      "SELECT name, sql FROM sqlite_master "
                      "WHERE sql IS NOT NULL AND type != 'trigger'");
  statement.With();
  while (statement.Next()) {
    const std::string name = statement.TakeText();
    found[name] = statement.TakeText();
  }
  for (const SchemaItem& item : Schema(SchemaOf(database)))
    if (found[item.name] != item.sql) return false;
  return true;
}

/// The first complaint of a PRAGMA that says "ok", or nothing, where all is
/// well.
MaybeFailure Complaint(Database& database, const char* sql) {
  Statement statement(database, sql);
  if (!statement.With().Next()) return database.TakeFailure();
  const std::string said = statement.TakeText();
  if (said == "ok") return std::nullopt;
  return Damaged(database, said.substr(0, said.find('\n')));
}

MaybeFailure CheckStructure(Database& database) {
  if (MaybeFailure failure = Complaint(database, "PRAGMA integrity_check(1)"))
    return failure;
  Statement keys(database, "PRAGMA foreign_key_check");
  if (keys.With().Next())
    return Damaged(database, fmt::format("a row of '{}' refers to one that is "
                                         "missing",
                                         keys.TakeText()));
  return database.TakeFailure();
}

/// Looks at a run generation by generation, to its end, whatever is wrong.
class Examination {
 public:
  explicit Examination(Database& database)
      : database_(database), checks_(database) {}

  Health Take();

 private:
  MaybeFailure CheckRun();
  void CheckGeneration(int number);
  void CheckIndividual(int id, int generation, bool is_complete);
  MaybeFailure Wrong(const std::string& what) {
    if (database_.has_failed()) return database_.TakeFailure();
    return Damaged(database_, what);
  }
  /// Whether there is nothing to be noted.
  bool Note(const MaybeFailure& failure) {
    if (!health_.problem) health_.problem = failure;
    return !failure;
  }

  Database& database_;
  RowChecks checks_;
  Experiment experiment_;
  int completed_ = 0;  // generations, as far as the table tells
  Health health_;
};

MaybeFailure Examination::CheckRun() {
  Statement run(database_, "SELECT experiment FROM run");
  if (!run.With().Next()) return Wrong("it does not say what the run is");
  Result<Experiment> experiment =
      ParseExperiment(Source(database_.path(), run.TakeText()));
  if (!experiment) return Wrong("what the run is cannot be trusted");
  run.Run();
  experiment_ = std::move(*experiment);
  completed_ = static_cast<int>(
      SingleInteger(database_, "SELECT count(*) FROM generation"));
  return database_.TakeFailure();
}

void Examination::CheckIndividual(int id, int generation, bool is_complete) {
  if (Note(checks_.Birth(id, generation))) health_.births.insert(id);
  int seasons = 0;
  MaybeFailure failure = checks_.Evaluation(id, seasons);
  const auto all = static_cast<int>(experiment_.scenario.seasons.size());
  if (!failure && seasons != all && (is_complete || seasons != 0))
    failure = Wrong(fmt::format("robot {} lacks an evaluation", id));
  if (Note(failure)) health_.evaluations.insert(id);
}

void Examination::CheckGeneration(int number) {
  const bool is_complete = number < completed_;
  const IdSpan ids = IdsBornIn(experiment_, number);
  if (!is_complete) {
    // All of them or nobody; and nobody beyond.
    const std::int64_t last =
        SingleInteger(database_, "SELECT ifnull(max(id), 0) FROM individual");
    if (last == ids.first - 1) {
      Note(database_.TakeFailure());
      return;
    }
    if (last != ids.last)
      Note(Wrong(fmt::format("generation {} lacks robots", number)));
  }
  for (int id = ids.first; id <= ids.last; ++id)
    CheckIndividual(id, number, is_complete);
  if (is_complete && Note(checks_.Generation(number)))
    health_.generations.insert(number);
}

Health Examination::Take() {
  if (!Note(CheckIdentity(database_)) || !Note(checks_.Run())) return health_;
  health_.is_run_whole = true;
  if (!Note(CheckRun())) return health_;
  const MaybeFailure missing = checks_.Completed(experiment_);
  const MaybeFailure broken = missing ? missing : CheckStructure(database_);
  // The last one is under way, if there is one to be made.
  const int last = std::min(completed_ + 1, experiment_.generations);
  for (int g = 0; g < last; ++g) {
    CheckGeneration(g);
    if (!health_.problem && !missing && g < completed_)
      ++health_.whole_generations;
  }
  if (broken) health_.problem = broken;
  return health_;
}

}  // namespace

MaybeFailure CheckIdentity(Database& database) {
  const std::int64_t application =
      SingleInteger(database, "PRAGMA application_id");
  const int version = SchemaOf(database);
  if (database.has_failed()) return database.TakeFailure();
  if (application == kRelivedApplicationId)
    return fmt::format(
        "'{}' is of lives that robots of a run lived again (plsc relive), and "
        "no run itself: name the run",
        database.path());
  if (application != kApplicationId)
    return fmt::format("'{}' is no run of plsc, but another program's file",
                       database.path());
  if (version > kSchemaVersion)
    return fmt::format(
        "'{}' was made by a newer plsc (its schema is {}, this program knows "
        "{}): use that one",
        database.path(), version, kSchemaVersion);
  if (version < kOldestSchema)
    return fmt::format("'{}' has schema {}, which this program does not read",
                       database.path(), version);
  const bool has_schema = HasSchema(database);
  if (database.has_failed()) return database.TakeFailure();
  if (!has_schema)
    return Damaged(database, "its tables are not those of a run");
  if (version < kSchemaVersion) AddWhatIsNew(database, version);
  return database.TakeFailure();
}

Health Examine(Database& database) {
  return Examination(database).Take();
}

Health Examine(const std::string& path) {
  Database database;
  if (MaybeFailure failure = database.Open(path, Database::Mode::kRead)) {
    Health health;
    health.problem = std::move(failure);
    return health;
  }
  Health health = Examine(database);
  if (health.problem)
    health.problem = fmt::format(
        "{}; {}, and 'plsc export' prints what can still be read; 'plsc evolve "
        "--salvage {} -o NEW' makes the run again with the simulations that "
        "are",
        health.problem->text,
        health.whole_generations == 0
            ? "no generation of it is whole"
            : fmt::format("generations 0 to {} are whole",
                          health.whole_generations - 1),
        path);
  return health;
}

}  // namespace plsc
