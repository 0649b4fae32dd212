#include "runtime/store/create.h"

#include <fmt/format.h>

#include "runtime/scenario/scenario_yaml.h"
#include "runtime/store/checksum.h"
#include "runtime/store/constants.h"
#include "runtime/store/database.h"
#include "runtime/store/make_database.h"
#include "runtime/store/schema.h"

namespace plsc {

namespace {

// Where a state would have to be kept, for streams that are not named by who
// needs them (docs/decisions/0003-random-streams.md).
constexpr const char* kRandom =
    "Philox4x64-10 keyed by seed, generation, individual, purpose";

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
      "INSERT INTO run VALUES(1, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, 0)");
  run.With(experiment.name, std::to_string(experiment.seed),
           experiment.generations, Evaluations(experiment), kRandom,
           versions.plsc, versions.ode, versions.compiler, versions.machine,
           versions.results, PrintExperiment(experiment),
           PrintScenario(experiment.scenario))
      .Run();
  Checksums checksums(database);
  Statement sum(database, "UPDATE run SET checksum = ?");
  sum.With(checksums.OfRun()).Run();
}

}  // namespace

MaybeFailure CreateStoreFile(const std::string& path,
                             const Experiment& experiment,
                             const Versions& versions, RunLock& lock) {
  return MakeDatabase(
      path,
      [&](Database& database) {
        AddSchema(database);
        AddConstants(database, experiment.scenario);
        AddRun(database, experiment, versions);
      },
      [&](int descriptor) { return lock.TakeNew(path, descriptor); });
}

}  // namespace plsc
