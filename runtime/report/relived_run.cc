#include "runtime/report/relived_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "grammar/shown_line.h"
#include "runtime/scenario/scenario_physics.h"
#include "runtime/text/aligned_rows.h"
#include "runtime/text/quantity.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;
using TableRows = std::vector<std::vector<std::string>>;

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view kSpeed = "displacement_velocity_hill";

std::size_t SpeedIndex() {
  const auto& names = RelivedMeasures();
  return static_cast<std::size_t>(
      std::find(names.begin(), names.end(), kSpeed) - names.begin());
}

double RecordedOf(const RelivedRun& run, int id, std::size_t place) {
  const auto found = run.recorded.find(id);
  if (found == run.recorded.end()) return kMissing;
  return found->second[place].value_or(kMissing);
}

double RecordedMean(const RelivedRun& run, const RelivedGeneration& generation,
                    std::size_t place) {
  double sum = 0;
  int count = 0;
  for (const RelivedRobotValues& robot : generation.robots) {
    const double value = RecordedOf(run, robot.id, place);
    if (std::isnan(value)) continue;
    sum += value;
    ++count;
  }
  return count == 0 ? kMissing : sum / count;
}

std::string SpeedText(double speed) {
  return std::isnan(speed) ? "-" : fmt::format("{:.2f}", kCentimetres * speed);
}

std::string RangeText(const Quartiles& quartiles) {
  if (std::isnan(quartiles.median)) return "-";
  return fmt::format("{} to {}", SpeedText(quartiles.low),
                     SpeedText(quartiles.high));
}

double ShareOf(double lost, double of) {
  return of == 0 ? kMissing : lost / std::abs(of);
}

std::string LostText(double before, double after) {
  const double lost = before - after;
  const double share = ShareOf(lost, before);
  if (std::isnan(lost)) return "-";
  // A share of next to nothing says nothing.
  constexpr double kMostShare = 10;
  if (!(std::abs(share) < kMostShare)) return SpeedText(lost);
  return fmt::format("{} ({:.0f} %)", SpeedText(lost), 100 * share);
}

/// What is told of a robot, or of all, in a season.
std::vector<std::string> RowOf(const std::string& whose, double recorded,
                               double relived, const Quartiles& quartiles) {
  return {whose, SpeedText(recorded), SpeedText(relived), RangeText(quartiles),
          LostText(recorded, relived)};
}

std::string Plural(int count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string LivesText(int count) {
  return count == 1 ? "1 life" : fmt::format("{} lives", count);
}

std::string RecordText(const RelivedRun& run,
                       const RelivedGeneration& generation) {
  TableRows rows = {
      {"season", "Speed of", "recorded", "relived", "quartiles", "lost, cm/s"}};
  for (std::size_t i = 0; i < run.seasons.size(); ++i) {
    const std::size_t place = SpeedIndex() * generation.seasons + i;
    const RelivedMeasure& speed = generation.of(SpeedIndex(), i);
    const auto add = [&](std::vector<std::string> row) {
      row.insert(row.begin(), Escaped(run.seasons[i]));
      rows.push_back(std::move(row));
    };
    const double best = RecordedOf(run, generation.best, place);
    add(RowOf(fmt::format("best, {}", generation.best), best,
              speed.best.quartiles.median, speed.best.quartiles));
    if (generation.other_lives > 0)
      add(RowOf("best, by " + run.other_engine, best,
                speed.best_by_other.quartiles.median,
                speed.best_by_other.quartiles));
    add(RowOf("mean", RecordedMean(run, generation, place), speed.mean,
              speed.medians));
  }
  return AlignedRows(rows);
}

std::string SwapText(const RelivedRun& run,
                     const RelivedGeneration& generation) {
  if (generation.swaps == 0) return "";
  TableRows rows = {{"season", "plastic", "own", "swapped", "quartiles of loss",
                     "lost, cm/s"}};
  for (std::size_t i = 0; i < run.seasons.size(); ++i) {
    const RelivedMeasure& speed = generation.of(SpeedIndex(), i);
    rows.push_back({Escaped(run.seasons[i]), Plural(speed.swapped, "robot"),
                    SpeedText(speed.own), SpeedText(speed.other),
                    RangeText(speed.losses), LostText(speed.own, speed.other)});
  }
  return fmt::format("with the other season's body and brain, {} each:\n",
                     LivesText(generation.swaps)) +
         AlignedRows(rows);
}

Json RawNumber(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

void AddRawQuartiles(const Quartiles& quartiles, Json& json) {
  json["low"] = RawNumber(quartiles.low);
  json["median"] = RawNumber(quartiles.median);
  json["high"] = RawNumber(quartiles.high);
}

Json ValueJson(double recorded, const RelivedValue& value) {
  const double lost = recorded - value.quartiles.median;
  Json json{{"recorded", RawNumber(recorded)}, {"lives", value.lives}};
  AddRawQuartiles(value.quartiles, json);
  json["lost"] = RawNumber(lost);
  json["lost_share"] = RawNumber(ShareOf(lost, recorded));
  return json;
}

Json MeasureJson(const RelivedRun& run, const RelivedGeneration& generation,
                 std::size_t measure, std::size_t season) {
  const std::size_t place = measure * generation.seasons + season;
  const RelivedMeasure& one = generation.of(measure, season);
  const double recorded = RecordedMean(run, generation, place);
  Json json{{"measure", RelivedMeasures()[measure]},
            {"season", run.seasons[season]}};
  json["mean"] = {
      {"recorded", RawNumber(recorded)},
      {"relived", RawNumber(one.mean)},
      {"lost", RawNumber(recorded - one.mean)},
      {"lost_share", RawNumber(ShareOf(recorded - one.mean, recorded))}};
  AddRawQuartiles(one.medians, json["mean"]);
  const double best = RecordedOf(run, generation.best, place);
  json["best"] = ValueJson(best, one.best);
  json["best_by_other_engine"] = generation.other_lives == 0
                                     ? Json(nullptr)
                                     : ValueJson(best, one.best_by_other);
  json["swap"] = nullptr;
  if (one.swapped > 0) {
    json["swap"] = {{"robots", one.swapped},
                    {"own", RawNumber(one.own)},
                    {"swapped", RawNumber(one.other)},
                    {"lost", RawNumber(one.own - one.other)}};
    AddRawQuartiles(one.losses, json["swap"]);
  }
  return json;
}

Json RobotJson(const RelivedRun& run, const RelivedGeneration& generation,
               const RelivedRobotValues& robot) {
  Json json{{"id", robot.id}, {"speed", Json::object()}};
  for (std::size_t i = 0; i < run.seasons.size(); ++i) {
    const std::size_t place = SpeedIndex() * generation.seasons + i;
    json["speed"][run.seasons[i]] =
        ValueJson(RecordedOf(run, robot.id, place), robot.values[place]);
  }
  return json;
}

}  // namespace

Expected<RelivedRun, Failure> ReadRelivedRun(RunStore& store,
                                             const ReliveSubjects& subjects,
                                             RelivedFile& file) {
  Expected<std::vector<RelivedSeason>, Failure> there = file.Lives();
  if (!there) return there.error();
  const RelivedLives lives(std::move(*there));
  RelivedRun run;
  run.run = store.path();
  run.file = RelivedPathOf(store.path());
  run.other_engine =
      NameIn(kEngineNames, OtherEngine(store.experiment().scenario));
  run.seasons = subjects.run.seasons;
  for (const RelivedMembers& members : subjects.generations)
    run.generations.push_back(
        SummariseRelived(members, run.seasons.size(), lives));
  for (const auto& [id, robot] : subjects.robots) {
    const Expected<Individual, Failure> one = store.Find(id);
    if (!one) return one.error();
    std::vector<std::optional<double>>& recorded = run.recorded[id];
    recorded.resize(RelivedMeasures().size() * run.seasons.size());
    const std::vector<SeasonResult>& seasons = one->evaluation.seasons;
    for (std::size_t i = 0; i < seasons.size(); ++i) {
      const auto values = MeasuresOf(seasons[i].behaviour, seasons[i].fitness);
      for (std::size_t measure = 0; measure < values.size(); ++measure)
        recorded[measure * run.seasons.size() + i] = values[measure];
    }
  }
  return run;
}

std::string RelivedText(const RelivedRun& run) {
  std::string text;
  for (const RelivedGeneration& generation : run.generations)
    text += fmt::format("{}, generation {}: {}, {} each\n", Escaped(run.run),
                        generation.generation,
                        Plural(generation.survivors, "survivor"),
                        LivesText(generation.lives)) +
            RecordText(run, generation) + SwapText(run, generation);
  return text;
}

Json RelivedJson(const RelivedRun& run) {
  Json json{{"run", run.run}, {"file", run.file}, {"seasons", run.seasons}};
  json["other_engine"] = run.other_engine;
  json["generations"] = Json::array();
  for (const RelivedGeneration& generation : run.generations) {
    Json one{{"generation", generation.generation},
             {"survivors", generation.survivors},
             {"best", generation.best},
             {"lives", generation.lives},
             {"swaps", generation.swaps},
             {"lives_by_other_engine", generation.other_lives}};
    one["measures"] = Json::array();
    for (std::size_t measure = 0; measure < RelivedMeasures().size(); ++measure)
      for (std::size_t season = 0; season < run.seasons.size(); ++season)
        one["measures"].push_back(
            MeasureJson(run, generation, measure, season));
    one["robots"] = Json::array();
    for (const RelivedRobotValues& robot : generation.robots)
      one["robots"].push_back(RobotJson(run, generation, robot));
    json["generations"].push_back(std::move(one));
  }
  return json;
}

}  // namespace plsc
