#include "runtime/cli/live/run_feed.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "compiler/print.h"
#include "runtime/scenario/scenario_yaml.h"
#include "runtime/store/census_json.h"
#include "runtime/store/heritage_json.h"
#include "runtime/store/lock.h"
#include "runtime/text/json_dump.h"

namespace plsc::cli {

namespace {

using Value = nlohmann::ordered_json;

Value OrNull(const std::vector<std::optional<double>>& values) {
  Value json = Value::array();
  for (const std::optional<double>& value : values)
    json.push_back(value ? Value(*value) : Value(nullptr));
  return json;
}

/// Of an even number the lower one: a robot has it.
std::optional<double> MedianOf(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto middle =
      values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Expected<bool, Failure> RunFeed::Look() {
  // Asked first: not to be asked of a store that is open.
  const bool is_running = WhoWorksOn(path_).has_value();
  RunStore store;
  if (auto failure = store.OpenForReading(path_)) return *failure;
  const Expected<RunStatus, Failure> status = store.Status();
  if (!status) return status.error();
  const std::string state = status->is_finished ? "finished"
                            : is_running        ? "running"
                                                : "unfinished";
  const Experiment& experiment = store.experiment();
  const std::string seed = std::to_string(experiment.seed);
  const std::string scenario = PrintScenario(experiment.scenario);
  if (seed != seed_ || scenario != scenario_ || name_ != experiment.name ||
      static_cast<std::size_t>(status->generations) < rows_.size()) {
    // Another run under the same name.
    *this = RunFeed(std::move(path_));
    name_ = experiment.name;
    seed_ = seed;
    scenario_ = scenario;
    has_own_fitness_ = HasOwnFitness(experiment);
    total_ = experiment.generations;
    for (const Season& season : experiment.scenario.seasons)
      seasons_.push_back(season.name);
  }
  const bool is_new =
      state != state_ ||
      static_cast<std::size_t>(status->generations) != rows_.size();
  state_ = state;
  while (rows_.size() < static_cast<std::size_t>(status->generations))
    if (auto failure = ReadRow(store, static_cast<int>(rows_.size())))
      return *failure;
  if (censuses_.size() < rows_.size()) {
    Expected<std::vector<CensusCounts>, Failure> censuses = store.Censuses();
    if (!censuses) return censuses.error();
    censuses_ = std::move(*censuses);
  }
  return is_new;
}

MaybeFailure RunFeed::ReadRow(RunStore& store, int generation) {
  Expected<GenerationRecord, Failure> record = store.Generation(generation);
  if (!record) return record.error();
  Row row{std::move(*record), {}, {}, {}};
  std::map<int, SeasonFitnesses> fitnesses;
  for (const int id : row.record.survivors) {
    const auto known = fitnesses_.find(id);
    if (known != fitnesses_.end()) {
      fitnesses.insert(*known);
      continue;
    }
    Expected<std::vector<Ancestor>, Failure> one = store.Lineage(id, 0);
    if (!one) return one.error();
    fitnesses.emplace(id, std::move(one->front().fitnesses));
  }
  for (std::size_t season = 0; season < seasons_.size(); ++season) {
    std::vector<double> values;
    int best_of = 0;
    std::optional<double> best;
    for (const int id : row.record.survivors) {
      const SeasonFitnesses& all = fitnesses.at(id);
      if (season >= all.size() || !all[season]) continue;
      values.push_back(*all[season]);
      if (!best || *all[season] > *best) {
        best = all[season];
        best_of = id;
      }
    }
    row.best_of.push_back(best_of);
    row.best.push_back(best);
    row.median.push_back(MedianOf(std::move(values)));
  }
  fitnesses_ = std::move(fitnesses);
  rows_.push_back(std::move(row));
  return std::nullopt;
}

int RunFeed::best() const {
  return rows_.empty() ? 0 : rows_.back().record.best;
}

std::string RunFeed::Summary() const {
  return DumpJson(Value{{"generations", rows_.size()}, {"state", state_}});
}

std::string RunFeed::Json() const {
  Value json;
  json["name"] = name_;
  json["seed"] = seed_;
  json["state"] = state_;
  json["total_generations"] = total_;
  json["seasons"] = seasons_;
  json["scenario"] = scenario_;
  json["own_fitness"] = has_own_fitness_;
  json["generations"] = Value::array();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    Value one;
    one["generation"] = row.record.generation;
    one["best"] = row.record.best;
    one["best_of"] = row.best_of;
    one["fitness"] = {{"best", OrNull(row.best)},
                      {"median", OrNull(row.median)}};
    one["census"] =
        i < censuses_.size() ? CensusJson(censuses_[i]) : Value(nullptr);
    json["generations"].push_back(std::move(one));
  }
  return DumpJson(json);
}

Expected<std::string, Failure> RunFeed::Robot(int id) const {
  RunStore store;
  if (auto failure = store.OpenForReading(path_)) return *failure;
  Expected<Individual, Failure> one = store.Find(id);
  if (!one) return one.error();
  Value json;
  const auto describe = [](const Individual& robot) {
    Value of;
    of["id"] = robot.id;
    of["generation"] = robot.generation;
    of.update(HeritageJson(robot.heritage, *robot.genotype.alphabet,
                           robot.genotype.states));
    of["fitness"] = OrNull(FitnessesOf(robot));
    of["genotype"] = Print(robot.genotype);
    return of;
  };
  json = describe(*one);
  json["lineage"] = Value::array();
  while (!one->heritage.parents.empty()) {
    one = store.Find(one->heritage.parents.front());
    if (!one) return one.error();
    json["lineage"].push_back(describe(*one));
  }
  return DumpJson(json);
}

}  // namespace plsc::cli
