#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "compiler/print.h"
#include "runtime/life/season_json.h"
#include "runtime/scenario/scenario_yaml.h"
#include "runtime/store/census_json.h"
#include "runtime/store/export.h"
#include "runtime/store/heritage_json.h"
#include "runtime/store/trials_json.h"
#include "runtime/store/verify.h"
#include "runtime/text/json_dump.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

std::string RunLine(const RunStore& store) {
  const Experiment& experiment = store.experiment();
  Json run;
  run["name"] = experiment.name;
  run["seed"] = std::to_string(experiment.seed);
  run["evaluations"] = Evaluations(experiment);
  run["seasons"] = Json::array();
  for (const Season& season : experiment.scenario.seasons)
    run["seasons"].push_back(season.name);
  const Versions& versions = store.versions();
  run["versions"] = {{"plsc", versions.plsc},
                     {"ode", versions.ode},
                     {"compiler", versions.compiler},
                     {"machine", versions.machine},
                     {"results", versions.results}};
  // With every constant of the physics, as text that reads back equal.
  run["experiment"] = PrintExperiment(experiment);
  run["scenario"] = PrintScenario(experiment.scenario);
  return DumpJson(Json{{"run", run}}) + "\n";
}

/// Nothing where there are none.
std::string TrialsText(const std::vector<std::vector<StoredTrial>>& trials) {
  return trials.empty() ? "" : ",\"trials\":" + DumpJson(TrialsJson(trials));
}

std::string IndividualLine(
    const Individual& one,
    const std::vector<std::vector<StoredTrial>>& trials) {
  Json json;
  json["id"] = one.id;
  json["generation"] = one.generation;
  json.update(
      HeritageJson(one.heritage, *one.genotype.alphabet, one.genotype.states));
  json["genotype"] = Print(one.genotype);
  std::string text = DumpJson(json);
  text.pop_back();  // the closing brace: the seasons are still to come
  std::string seasons;
  for (const SeasonResult& season : one.evaluation.seasons) {
    if (!seasons.empty()) seasons += ',';
    seasons += SeasonJson(one.genotype, season);
  }
  return fmt::format("{{\"individual\":{},\"seasons\":[{}]{}}}}}\n", text,
                     seasons, TrialsText(trials));
}

std::string GenerationLine(const GenerationRecord& record,
                           const std::vector<CensusCounts>& censuses) {
  Json json;
  json["generation"] = record.generation;
  json["best"] = record.best;
  json["pool"] = record.pool;
  json["counts"] = record.counts;
  json["survivors"] = record.survivors;
  const auto number = static_cast<std::size_t>(record.generation);
  json["census"] =
      number < censuses.size() ? CensusJson(censuses[number]) : Json(nullptr);
  return DumpJson(json) + "\n";
}

Expected<Health, Failure> HealthOf(const std::string& run) {
  Database database;
  if (auto failure = database.Open(run, Database::Mode::kRead)) return *failure;
  const Transaction instant(database);
  Health health = Examine(database);
  if (auto failure = database.TakeFailure()) return *failure;
  return health;
}

}  // namespace

MaybeFailure WriteJsonl(const std::string& run, const Sink& sink) {
  RunStore store;
  if (auto failure = store.OpenForReading(run)) return failure;
  const Expected<Health, Failure> health = HealthOf(run);
  if (!health) return health.error();
  if (auto failure = sink(RunLine(store))) return failure;
  // What can be read of a damaged run is written; the rest is told at the end.
  MaybeFailure damage = health->problem;
  for (const int id : health->births) {
    if (!health->evaluations.contains(id)) continue;
    const Expected<Individual, Failure> one = store.Find(id);
    if (!one) {
      if (!damage) damage = one.error();
      continue;
    }
    const auto trials = store.TrialsOf(id);
    if (!trials) {
      if (!damage) damage = trials.error();
      continue;
    }
    if (auto failure = sink(IndividualLine(*one, *trials))) return failure;
  }
  const auto censuses = store.Censuses();
  for (const int number : health->generations) {
    const Expected<GenerationRecord, Failure> record = store.Generation(number);
    if (!record) {
      if (!damage) damage = record.error();
      continue;
    }
    if (auto failure = sink(GenerationLine(
            *record, censuses ? *censuses : std::vector<CensusCounts>{})))
      return failure;
  }
  return damage;
}

}  // namespace plsc
