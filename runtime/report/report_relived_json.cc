#include "runtime/report/report_relived_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "runtime/report/rounded_json.h"
#include "runtime/report/swaps.h"
#include "runtime/report/wilcoxon.h"
#include "runtime/text/quantity.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

void AddSpeeds(const RelivedValue& value, Json& json) {
  json["lives"] = value.lives;
  json["low"] = RoundedNumber(kCentimetres * value.quartiles.low);
  json["median"] = RoundedNumber(kCentimetres * value.quartiles.median);
  json["high"] = RoundedNumber(kCentimetres * value.quartiles.high);
}

Json BestJson(const ReportRun& run) {
  const RelivedGeneration& generation = run.relived.generation;
  const std::vector<std::string>& names = RelivedMeasures();
  const auto speed = static_cast<std::size_t>(
      std::find(names.begin(), names.end(), "displacement_velocity_hill") -
      names.begin());
  Json json = Json::array();
  const auto& seasons = run.reading.population.seasons;
  for (std::size_t i = 0; i < std::min(generation.seasons, seasons.size());
       ++i) {
    const RelivedMeasure& one = generation.of(speed, i);
    Json season{{"season", seasons[i]}};
    AddSpeeds(one.best, season);
    season["by_other_engine"] = nullptr;
    if (generation.other_lives > 0)
      AddSpeeds(one.best_by_other, season["by_other_engine"]);
    json.push_back(std::move(season));
  }
  return json;
}

}  // namespace

Json RelivedOfRunJson(const ReportRun& run) {
  const RelivedReading& relived = run.relived;
  Json json{{"state", NameIn(kRelivedStateNames, relived.state)},
            {"problem",
             relived.problem.empty() ? Json(nullptr) : Json(relived.problem)}};
  if (relived.state != RelivedState::kHere) return json;
  const RelivedGeneration& generation = relived.generation;
  json["generation"] = generation.generation;
  json["robots"] = generation.survivors;
  json["lives"] = generation.lives;
  json["swaps"] = generation.swaps;
  json["best"] = generation.best;
  json["speeds"] = BestJson(run);
  return json;
}

Json SwapsJson(const StudyReport& report) {
  Json json = Json::array();
  for (const SwapLosses& one : SwapLossesOf(report)) {
    Json item{{"measure", one.measure},
              {"unit", "cm/s"},
              {"season", report.seasons[one.season]},
              {"experiment", report.experiments[one.experiment].name},
              {"low_whisker", RoundedNumber(one.box.low_whisker)},
              {"low", RoundedNumber(one.box.quartiles.low)},
              {"median", RoundedNumber(one.box.quartiles.median)},
              {"high", RoundedNumber(one.box.quartiles.high)},
              {"high_whisker", RoundedNumber(one.box.high_whisker)},
              {"mean", RoundedNumber(one.box.mean)}};
    item["v"] = one.result ? Json(one.result->v) : Json(nullptr);
    item["p"] = one.result ? RoundedNumber(one.result->p) : Json(nullptr);
    item["stars"] = one.result ? Stars(one.result->p) : "";
    item["values"] = Json::array();
    for (const RunSwap& run : one.runs)
      item["values"].push_back(
          {{"run", report.runs[run.run].input.label},
           {"robots", run.robots},
           {"own", RoundedNumber(run.own)},
           {"swapped", RoundedNumber(run.swapped)},
           {"value", RoundedNumber(run.own - run.swapped)}});
    json.push_back(std::move(item));
  }
  return json;
}

Json RelivedSummaryJson(const StudyReport& report) {
  int here = 0;
  int readable = 0;
  int least = 0;
  int most = 0;
  for (const ReportRun& run : report.runs) {
    if (run.reading.state == RunState::kMissing ||
        run.reading.state == RunState::kDamaged)
      continue;
    ++readable;
    if (run.relived.state != RelivedState::kHere) continue;
    const int lives = run.relived.generation.lives;
    least = here == 0 ? lives : std::min(least, lives);
    most = std::max(most, lives);
    ++here;
  }
  return {
      {"runs", here},
      {"of", readable},
      {"least_lives", least},
      {"most_lives", most},
      {"command", report.relive_command.empty() ? Json(nullptr)
                                                : Json(report.relive_command)}};
}

}  // namespace plsc
