#include "runtime/report/engine_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "grammar/shown_line.h"
#include "runtime/scenario/scenario_physics.h"
#include "runtime/text/quantity.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

/// From 1; equal values have the mean of theirs.
std::vector<double> RanksOf(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return values[a] < values[b];
  });
  std::vector<double> ranks(values.size());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && values[order[end]] == values[order[begin]])
      ++end;
    for (std::size_t i = begin; i < end; ++i)
      ranks[order[i]] = static_cast<double>(begin + 1 + end) / 2;
    begin = end;
  }
  return ranks;
}

std::optional<double> SpeedOf(const SeasonResult& result) {
  if (!result.behaviour.is_valid) return std::nullopt;
  return result.behaviour.displacement_velocity_hill;
}

void Compare(SeasonCheck& season) {
  std::vector<double> stored;
  std::vector<double> now;
  std::vector<double> differences;
  for (const CheckedLife& life : season.lives) {
    season.only_stored += life.stored && !life.now ? 1 : 0;
    season.only_now += !life.stored && life.now ? 1 : 0;
    if (!life.stored || !life.now) continue;
    stored.push_back(*life.stored);
    now.push_back(*life.now);
    differences.push_back(std::abs(*life.now - *life.stored));
  }
  season.both = static_cast<int>(stored.size());
  season.rank_correlation = RankCorrelation(stored, now);
  if (differences.empty()) return;
  std::sort(differences.begin(), differences.end());
  season.median_difference = differences[(differences.size() - 1) / 2];
  season.largest_difference = differences.back();
}

std::string NumberText(const std::optional<double>& value, double scale,
                       int digits) {
  return value ? fmt::format("{:.{}f}", scale * *value, digits) : "-";
}

Json NumberOrNull(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace

std::optional<double> RankCorrelation(const std::vector<double>& x,
                                      const std::vector<double>& y) {
  assert(x.size() == y.size());
  const std::vector<double> a = RanksOf(x);
  const std::vector<double> b = RanksOf(y);
  const double middle = (static_cast<double>(x.size()) + 1) / 2;
  double ab = 0;
  double aa = 0;
  double bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - middle) * (b[i] - middle);
    aa += (a[i] - middle) * (a[i] - middle);
    bb += (b[i] - middle) * (b[i] - middle);
  }
  if (aa == 0 || bb == 0) return std::nullopt;
  return ab / std::sqrt(aa * bb);
}

std::vector<SeasonCheck> CheckSeasons(const Scenario& stored,
                                      const std::vector<LivedTwice>& robots) {
  std::vector<SeasonCheck> checks;
  for (std::size_t i = 0; i < stored.seasons.size(); ++i) {
    SeasonCheck& check = checks.emplace_back();
    check.season = stored.seasons[i].name;
    check.stored_engine = stored.seasons[i].physics.engine;
    for (const LivedTwice& robot : robots)
      check.lives.push_back({robot.id, SpeedOf(robot.stored.seasons[i]),
                             SpeedOf(robot.now.seasons[i])});
    Compare(check);
  }
  return checks;
}

std::string EngineCheckText(const EngineCheck& check) {
  std::string text = fmt::format(
      "{} robot{}{}, by the engine {}\n", check.robots,
      check.robots == 1 ? "" : "s",
      check.generation < 0 ? std::string()
                           : fmt::format(" of generation {}", check.generation),
      NameIn(kEngineNames, check.engine));
  text +=
      fmt::format("{:<12} {:<11} {:>5} {:>11} {:>8}  {:>6}  {:>11} {:>12}\n",
                  "season", "stored by", "both", "only stored", "only now",
                  "ranks", "median cm/s", "largest cm/s");
  for (const SeasonCheck& season : check.seasons)
    text += fmt::format(
        "{:<12} {:<11} {:>5} {:>11} {:>8}  {:>6}  {:>11} {:>12}\n",
        Escaped(season.season), NameIn(kEngineNames, season.stored_engine),
        season.both, season.only_stored, season.only_now,
        NumberText(season.rank_correlation, 1, 3),
        NumberText(season.median_difference, kCentimetres, 3),
        NumberText(season.largest_difference, kCentimetres, 3));
  return text;
}

Json EngineCheckJson(const EngineCheck& check) {
  Json json;
  json["engine"] = NameIn(kEngineNames, check.engine);
  json["generation"] =
      check.generation < 0 ? Json(nullptr) : Json(check.generation);
  json["robots"] = check.robots;
  json["seasons"] = Json::array();
  for (const SeasonCheck& season : check.seasons) {
    Json one;
    one["season"] = season.season;
    one["stored_engine"] = NameIn(kEngineNames, season.stored_engine);
    one["both"] = season.both;
    one["only_stored"] = season.only_stored;
    one["only_now"] = season.only_now;
    one["rank_correlation"] = NumberOrNull(season.rank_correlation);
    one["median_difference"] = NumberOrNull(season.median_difference);
    one["largest_difference"] = NumberOrNull(season.largest_difference);
    one["lives"] = Json::array();
    for (const CheckedLife& life : season.lives)
      one["lives"].push_back({{"id", life.id},
                              {"stored", NumberOrNull(life.stored)},
                              {"now", NumberOrNull(life.now)}});
    json["seasons"].push_back(std::move(one));
  }
  return json;
}

}  // namespace plsc
