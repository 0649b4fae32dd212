// A damaged store is read as a cache of simulations and nothing else: to mend
// its rows would be to guess, while a run made again from its experiment is
// right by construction and takes only the simulations that are lost. Each
// evaluation is taken or left by its own checksum. They are asked for one by
// one, since one damaged page ends every query that meets it, and a query over
// all would end with the first.

#include "runtime/store/salvage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "runtime/life/simulated.h"
#include "runtime/store/checksum.h"
#include "runtime/store/database.h"
#include "runtime/store/run_reader.h"
#include "runtime/store/schema.h"
#include "runtime/store/trial_rows.h"
#include "runtime/store/verify.h"

namespace plsc {

namespace {

/// Sums of an individual's evaluation by season, from 1 and without a gap.
std::vector<std::int64_t> SumsOf(Statement& statement, int id) {
  std::vector<std::int64_t> sums;
  statement.With(id);
  while (statement.Next()) sums.push_back(statement.TakeInteger());
  return sums;
}

}  // namespace

MaybeFailure Salvage::Open(const std::string& path) {
  Database database;
  if (MaybeFailure failure = database.Open(path, Database::Mode::kSalvage))
    return failure;
  if (MaybeFailure failure = CheckIdentity(database)) return failure;
  schema_ = SchemaOf(database);
  Checksums checksums(database);
  {
    Statement run(database,
                  "SELECT checksum, experiment, plsc, ode, compiler, machine, "
                  "results FROM run");
    if (run.With().Next()) {
      const std::int64_t sum = run.TakeInteger();
      const Result<Experiment> parsed =
          ParseExperiment(Source(path, run.TakeText()));
      versions_.plsc = run.TakeText();
      versions_.ode = run.TakeText();
      versions_.compiler = run.TakeText();
      versions_.machine = run.TakeText();
      versions_.results = run.TakeInt();
      if (parsed && sum == checksums.OfRun()) experiment_ = *parsed;
    }
    database.TakeFailure();  // then there is no experiment
  }
  if (!MissingMeasures(schema_).empty()) return std::nullopt;
  Statement evaluation(database,
                       "SELECT checksum FROM evaluation WHERE individual = ? "
                       "ORDER BY season");
  RunReader reader(database);
  TrialRows trials(database);
  if (MaybeFailure failure = database.TakeFailure()) return failure;
  // One by one, because a damaged page ends every query that meets it. Without
  // an experiment the end is not known; then as many as a run can have.
  const std::int64_t last =
      experiment_ ? plsc::Evaluations(*experiment_) : reader.Evaluations();
  database.TakeFailure();
  for (int id = 1; id <= static_cast<int>(last); ++id) {
    const std::vector<std::int64_t> sums = SumsOf(evaluation, id);
    const std::vector<SeasonEvidence> evidence = reader.FindEvidence(id);
    const auto lived = trials.Find(id);
    const bool is_readable =
        !database.TakeFailure() && sums.size() == evidence.size();
    for (std::size_t i = 0; is_readable && i < sums.size(); ++i) {
      const bool is_whole =
          sums[i] == checksums.OfEvaluation(id, static_cast<int>(i) + 1);
      if (database.TakeFailure() || !is_whole) continue;
      if (evidence[i].simulation != Key{})
        known_.emplace(evidence[i].simulation, evidence[i].simulated);
      if (i < lived.size()) TakeTrials(lived[i], reader);
    }
  }
  return std::nullopt;
}

void Salvage::TakeTrials(const std::vector<StoredTrial>& trials,
                         RunReader& reader) {
  for (const StoredTrial& trial : trials)
    if (auto simulated = reader.FindSimulation(trial.simulation))
      known_.emplace(trial.simulation, std::move(*simulated));
}

std::optional<Simulated> Salvage::Find(const Key& key) {
  const auto found = known_.find(key);
  if (found == known_.end()) return std::nullopt;
  return found->second;
}

MaybeFailure Salvage::Add(const Key& /*key*/, const Simulated& /*simulated*/) {
  return std::nullopt;
}

}  // namespace plsc
