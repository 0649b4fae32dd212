// A disturbance is stored number by number, so that it can be asked about in
// SQL, and exactly, so that the life can be lived again: replay takes it from
// here and draws nothing. Seeds are text, as SQLite's integers hold only half
// of them.

#include "runtime/store/trial_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "grammar/enum_names.h"
#include "grammar/number.h"
#include "runtime/store/names.h"

namespace plsc {

namespace {

constexpr const char* kColumns =
    "season, phenotype, simulation, outcome, reason, fitness, lift, shift_x, "
    "shift_y, yaw, friction, lean, touch, touch_seed, motor, motor_seed";

std::optional<std::string> HexIfAny(const Key& key) {
  if (key == Key{}) return std::nullopt;
  return Hex(key);
}

Key TakeHexKey(Statement& row, bool& is_damaged) {
  const bool is_there = !row.IsNull();
  const auto key = KeyOfHex(row.TakeText());
  is_damaged = is_damaged || (is_there && !key);
  return key.value_or(Key{});
}

Noise TakeNoise(Statement& row, bool& is_damaged) {
  Noise noise;
  noise.amplitude = row.TakeReal();
  const auto seed = ParseNumber<std::uint64_t>(row.TakeText());
  is_damaged = is_damaged || !seed;
  noise.seed = seed.value_or(0);
  return noise;
}

StoredTrial TakeTrial(Statement& row, bool& is_damaged) {
  StoredTrial trial;
  trial.phenotype = TakeHexKey(row, is_damaged);
  trial.simulation = TakeHexKey(row, is_damaged);
  const auto outcome = ValueIn(kOutcomeNames, row.TakeText());
  is_damaged = is_damaged || !outcome;
  trial.outcome = outcome.value_or(Outcome{});
  trial.reason = row.TakeText();
  trial.fitness = row.TakeOptional();
  Disturbance& disturbance = trial.disturbance;
  disturbance.lift = row.TakeReal();
  disturbance.shift_x = row.TakeReal();
  disturbance.shift_y = row.TakeReal();
  disturbance.yaw = row.TakeReal();
  disturbance.friction = row.TakeReal();
  disturbance.lean = row.TakeReal();
  disturbance.touch = TakeNoise(row, is_damaged);
  disturbance.motor = TakeNoise(row, is_damaged);
  return trial;
}

}  // namespace

TrialRows::TrialRows(Database& database, bool is_writing)
    : database_(database),
      insert_(database,
              is_writing
                  ? fmt::format("INSERT INTO trial(individual, number, {}) "
                                "VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
                                "?, ?, ?, ?, ?)",
                                kColumns)
                  : std::string("SELECT 1")),
      remove_(database, is_writing ? "DELETE FROM trial WHERE individual = ?"
                                   : "SELECT 1"),
      find_(database, fmt::format("SELECT {} FROM trial WHERE individual = ? "
                                  "ORDER BY season, number",
                                  kColumns)) {}

void TrialRows::Add(int individual, int season,
                    const std::vector<Trial>& trials) {
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const auto& [disturbance, result, evidence] = trials[i];
    const auto& [lift, x, y, yaw, friction, lean, touch, motor] = disturbance;
    insert_
        .With(individual, static_cast<std::int64_t>(i) + 1, season,
              HexIfAny(evidence.phenotype),
              HasSimulation(trials[i]) ? HexIfAny(evidence.simulation)
                                       : std::nullopt,
              OutcomeName(result.outcome), result.reason, result.fitness)
        .And(lift)
        .And(x)
        .And(y)
        .And(yaw)
        .And(friction)
        .And(lean)
        .And(touch.amplitude)
        .And(std::to_string(touch.seed))
        .And(motor.amplitude)
        .And(std::to_string(motor.seed))
        .Run();
  }
}

void TrialRows::Remove(int individual) {
  remove_.With(individual).Run();
}

std::vector<std::vector<StoredTrial>> TrialRows::Find(int individual) {
  std::vector<std::vector<StoredTrial>> seasons;
  bool is_damaged = false;
  find_.With(individual);
  while (find_.Next()) {
    const auto season = static_cast<std::size_t>(find_.TakeInteger());
    StoredTrial trial = TakeTrial(find_, is_damaged);
    is_damaged = is_damaged || season < 1 || season > seasons.size() + 1;
    if (is_damaged) continue;
    seasons.resize(std::max(seasons.size(), season));
    seasons[season - 1].push_back(std::move(trial));
  }
  if (is_damaged)
    database_.Fail(
        fmt::format("'{}' is damaged: the trials of robot {} cannot "
                    "be read",
                    database_.path(), individual));
  return seasons;
}

bool HasSimulation(const Trial& trial) {
  return trial.evidence.simulation != Key{} &&
         trial.result.outcome != Outcome::kWorkerDied;
}

}  // namespace plsc
