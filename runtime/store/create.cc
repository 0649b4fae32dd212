#include "runtime/store/create.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "runtime/store/checksum.h"
#include "runtime/store/constants.h"
#include "runtime/store/database.h"
#include "runtime/store/schema.h"

namespace plsc {

namespace {

using Failure = std::optional<std::string>;

// Where a state would have to be kept, for streams that are not named by who
// needs them (docs/decisions/0003-random-streams.md).
constexpr const char* kRandom =
    "Philox4x64-10 keyed by seed, generation, individual, purpose";

std::string SystemReason(int error) {
  return std::error_code(error, std::generic_category()).message();
}

void AddSchema(Database& database) {
  database.Run(
      fmt::format("PRAGMA application_id = {}; PRAGMA user_version = "
                  "{}",
                  kApplicationId, kSchemaVersion));
  for (const SchemaItem& item : Schema()) database.Run(item.sql);
}

void AddConstants(Database& database, const Scenario& scenario) {
  Statement season(database, "INSERT INTO season VALUES(?, ?)");
  Statement constant(database, "INSERT INTO physics VALUES(?, ?, ?, ?)");
  int id = 0;
  for (const Season& one : scenario.seasons) {
    season.With(++id, one.name).Run();
    for (const ScenarioConstant& value : ConstantsOf(scenario, one)) {
      constant.With(id, value.name);
      if (value.number)
        constant.And(*value.number);
      else
        constant.And(value.text);
      constant.And(value.unit).Run();
    }
  }
}

void AddRun(Database& database, const Experiment& experiment,
            const Versions& versions) {
  Statement run(
      database,
      "INSERT INTO run VALUES(1, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, 0)");
  run.With(experiment.name, std::to_string(experiment.seed),
           experiment.generations, Evaluations(experiment), kRandom,
           versions.plsc, versions.ode, versions.compiler, versions.machine,
           PrintExperiment(experiment), PrintScenario(experiment.scenario))
      .Run();
  Checksums checksums(database);
  Statement sum(database, "UPDATE run SET checksum = ?");
  sum.With(checksums.OfRun()).Run();
}

Failure Fill(const std::string& path, const Experiment& experiment,
             const Versions& versions) {
  Database database;
  if (Failure failure = database.Open(path, Database::Mode::kCreate))
    return failure;
  // Stays with the file. Readers and the writer do not wait for each other.
  database.Run("PRAGMA journal_mode = WAL");
  Failure failure;
  {
    Transaction transaction(database);
    AddSchema(database);
    AddConstants(database, experiment.scenario);
    AddRun(database, experiment, versions);
    failure = transaction.Commit();
  }
  database.Close();
  return failure;
}

void Remove(const std::string& path) {
  for (const char* end : {"", "-wal", "-shm"}) {
    std::error_code ignored;
    std::filesystem::remove(path + end, ignored);
  }
}

}  // namespace

Failure CreateStoreFile(const std::string& path, const Experiment& experiment,
                        const Versions& versions) {
  // Beside it first: a kill in between leaves no store that is half made.
  const std::string beside = path + ".new";
  Remove(beside);
  if (Failure failure = Fill(beside, experiment, versions)) {
    Remove(beside);
    return failure;
  }
  if (std::rename(beside.c_str(), path.c_str()) != 0) {
    const int error = errno;
    Remove(beside);
    return fmt::format("cannot create '{}': {}", path, SystemReason(error));
  }
  return std::nullopt;
}

}  // namespace plsc
