#include "runtime/store/verify.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "runtime/evolve/experiment.h"
#include "runtime/store/checksum.h"
#include "runtime/store/schema.h"

namespace plsc {

namespace {

using Failure = std::optional<std::string>;

std::int64_t Single(Database& database, const std::string& sql) {
  Statement statement(database, sql);
  return statement.With().Next() ? statement.TakeInteger() : 0;
}

std::string Damaged(const Database& database, const std::string& what) {
  return fmt::format("'{}' is damaged: {}", database.path(), what);
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
  for (const SchemaItem& item : Schema())
    if (found[item.name] != item.sql) return false;
  return true;
}

/// The first complaint of a PRAGMA that says "ok", or nothing, where all is
/// well.
Failure Complaint(Database& database, const char* sql) {
  Statement statement(database, sql);
  if (!statement.With().Next()) return database.TakeFailure();
  const std::string said = statement.TakeText();
  if (said == "ok") return std::nullopt;
  return Damaged(database, said.substr(0, said.find('\n')));
}

Failure CheckStructure(Database& database) {
  if (Failure failure = Complaint(database, "PRAGMA integrity_check(1)"))
    return failure;
  Statement keys(database, "PRAGMA foreign_key_check");
  if (keys.With().Next())
    return Damaged(database, fmt::format("a row of '{}' refers to one that is "
                                         "missing",
                                         keys.TakeText()));
  return database.TakeFailure();
}

/// Looks at a run generation by generation.
class Examination {
 public:
  explicit Examination(Database& database)
      : database_(database),
        sums_(database),
        individual_(database,
                    "SELECT generation, checksum FROM individual WHERE id = ?"),
        evaluations_(database,
                     "SELECT season, checksum FROM evaluation "
                     "WHERE individual = ? ORDER BY season"),
        generation_(database,
                    "SELECT checksum FROM generation WHERE number = ?") {}

  Failure CheckRun();
  /// Of generation `number`, or of the one under way.
  Failure CheckGeneration(int number);
  int generations() const { return generations_; }
  /// Completed, as far as the table tells.
  int completed() const { return completed_; }

 private:
  struct Span {
    int first = 0, last = 0;  // ids
  };
  Span IdsOf(int number) const;
  Failure CheckIndividual(int id, int generation, bool is_complete);
  Failure CheckMembers(int number);
  Failure Wrong(const std::string& what) {
    if (database_.has_failed()) return database_.TakeFailure();
    return Damaged(database_, what);
  }

  Database& database_;
  Checksums sums_;
  Statement individual_;
  Statement evaluations_;
  Statement generation_;
  int generations_ = 0;
  int completed_ = 0;
  int population_ = 0;
  int offspring_ = 0;
  int seasons_ = 0;
};

Failure Examination::CheckRun() {
  Statement run(database_, "SELECT checksum, experiment FROM run");
  if (!run.With().Next()) return Wrong("it does not say what the run is");
  const std::int64_t sum = run.TakeInteger();
  const Source yaml(database_.path(), run.TakeText());
  run.Run();
  const Result<Experiment> experiment = ParseExperiment(yaml);
  if (sum != sums_.OfRun() || !experiment)
    return Wrong("what the run is cannot be trusted");
  generations_ = experiment->generations;
  population_ = experiment->population;
  offspring_ = experiment->offspring;
  seasons_ = static_cast<int>(experiment->scenario.seasons.size());
  completed_ =
      static_cast<int>(Single(database_, "SELECT count(*) FROM generation"));
  if (completed_ > generations_ ||
      completed_ !=
          Single(database_,
                 "SELECT ifnull(max(number), -1) + 1 FROM generation"))
    return Wrong("a generation is missing");
  return database_.TakeFailure();
}

Examination::Span Examination::IdsOf(int number) const {
  if (number == 0) return {1, population_};
  const int first = population_ + (number - 1) * offspring_ + 1;
  return {first, first + offspring_ - 1};
}

Failure Examination::CheckIndividual(int id, int generation, bool is_complete) {
  if (!individual_.With(id).Next())
    return Wrong(fmt::format("robot {} is missing", id));
  const bool is_in_place = individual_.TakeInt() == generation;
  const std::int64_t sum = individual_.TakeInteger();
  individual_.Run();
  if (!is_in_place || sum != sums_.OfIndividual(id))
    return Wrong(fmt::format("robot {} is not as it was born", id));
  std::map<int, std::int64_t> seasons;
  evaluations_.With(id);
  while (evaluations_.Next()) {
    const int season = evaluations_.TakeInt();
    seasons[season] = evaluations_.TakeInteger();
  }
  for (const auto& [season, its_sum] : seasons)
    if (its_sum != sums_.OfEvaluation(id, season))
      return Wrong(
          fmt::format("the evaluation of robot {} is not what it was", id));
  const int count = static_cast<int>(seasons.size());
  if (count != seasons_ && (is_complete || count != 0))
    return Wrong(fmt::format("robot {} lacks an evaluation", id));
  return database_.TakeFailure();
}

Failure Examination::CheckMembers(int number) {
  if (!generation_.With(number).Next())
    return Wrong(fmt::format("generation {} is missing", number));
  const std::int64_t sum = generation_.TakeInteger();
  generation_.Run();
  if (sum != sums_.OfGeneration(number))
    return Wrong(fmt::format("generation {} is not what it was", number));
  return database_.TakeFailure();
}

Failure Examination::CheckGeneration(int number) {
  const bool is_complete = number < completed_;
  const Span ids = IdsOf(number);
  if (!is_complete) {
    // All of them or nobody; and nobody beyond.
    const std::int64_t last =
        Single(database_, "SELECT ifnull(max(id), 0) FROM individual");
    if (last == ids.first - 1) return database_.TakeFailure();
    if (last != ids.last)
      return Wrong(fmt::format("generation {} lacks robots", number));
  }
  for (int id = ids.first; id <= ids.last; ++id)
    if (Failure failure = CheckIndividual(id, number, is_complete))
      return failure;
  if (is_complete) return CheckMembers(number);
  return std::nullopt;
}

Health ExamineOpen(Database& database) {
  Health health;
  health.problem = CheckIdentity(database);
  if (health.problem) return health;
  Examination examination(database);
  health.problem = examination.CheckRun();
  if (health.problem) return health;
  health.problem = CheckStructure(database);
  // The last one is under way, if there is one to be made.
  for (int g = 0; g <= examination.completed(); ++g) {
    if (g == examination.generations()) break;
    Failure failure = examination.CheckGeneration(g);
    if (failure) {
      if (!health.problem) health.problem = std::move(failure);
      break;
    }
    if (g < examination.completed()) ++health.whole_generations;
  }
  return health;
}

}  // namespace

Failure CheckIdentity(Database& database) {
  const std::int64_t application = Single(database, "PRAGMA application_id");
  const std::int64_t version = Single(database, "PRAGMA user_version");
  if (database.has_failed()) return database.TakeFailure();
  if (application != kApplicationId)
    return fmt::format("'{}' is no run of plsc, but another program's file",
                       database.path());
  if (version > kSchemaVersion)
    return fmt::format(
        "'{}' was made by a newer plsc (its schema is {}, this program knows "
        "{}): use that one",
        database.path(), version, kSchemaVersion);
  if (version < kSchemaVersion)
    return fmt::format("'{}' has schema {}, which this program does not read",
                       database.path(), version);
  const bool has_schema = HasSchema(database);
  if (database.has_failed()) return database.TakeFailure();
  if (!has_schema)
    return Damaged(database, "its tables are not those of a run");
  return std::nullopt;
}

Health Examine(const std::string& path) {
  Database database;
  if (Failure failure = database.Open(path, Database::Mode::kRead))
    return {std::move(failure), 0};
  Health health = ExamineOpen(database);
  if (health.problem) {
    *health.problem += health.whole_generations == 0
                           ? "; no generation of it is whole"
                           : fmt::format("; generations 0 to {} are whole",
                                         health.whole_generations - 1);
    *health.problem +=
        ", and 'plsc export' prints what can still be read; "
        "'plsc evolve --salvage " +
        path + " -o NEW' makes the run again with the simulations that are";
  }
  return health;
}

}  // namespace plsc
