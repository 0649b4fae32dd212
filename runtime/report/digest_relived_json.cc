// By measure and season, as a run's series are. Robots are not kept one by one:
// no figure shows them, and a hundred of them are more than the rest of a run.

#include "runtime/report/digest_relived_json.h"

#include <algorithm>
#include <array>
#include <limits>

#include "runtime/report/rounded_json.h"

namespace plsc {

namespace {

using JsonOut = nlohmann::ordered_json;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t kMostLives = std::numeric_limits<int>::max();

bool IsKeptRelived(const Digest& digest, const std::string& measure) {
  return measure == "displacement_velocity_hill" || measure == "fitness" ||
         std::any_of(
             digest.measures.begin(), digest.measures.end(),
             [&](const ReportMeasure& one) { return one.id == measure; });
}

JsonOut KeptQuartiles(const Quartiles& quartiles) {
  return {RoundedNumber(quartiles.low), RoundedNumber(quartiles.median),
          RoundedNumber(quartiles.high)};
}

JsonOut KeptMeasure(const RelivedMeasure& one) {
  JsonOut json{{"mean", RoundedNumber(one.mean)},
               {"best", KeptQuartiles(one.best.quartiles)},
               {"lives", one.best.lives}};
  if (one.best_by_other.lives > 0) {
    json["by_other_engine"] = KeptQuartiles(one.best_by_other.quartiles);
    json["lives_by_other_engine"] = one.best_by_other.lives;
  }
  if (one.swapped > 0)
    json["swap"] = {{"robots", one.swapped},
                    {"own", RoundedNumber(one.own)},
                    {"swapped", RoundedNumber(one.other)}};
  return json;
}

int ReadCount(JsonReader& reader, const JsonValue& object,
              std::string_view key) {
  return static_cast<int>(reader.Integer(object, key, 0, kMostLives));
}

Quartiles ReadQuartiles(JsonReader& reader, const JsonValue& object,
                        std::string_view key) {
  std::vector<double> values;
  reader.List(object, key, [&](const JsonValue& one) {
    values.push_back(one.json.is_null() ? kUnknown : reader.Number(one));
  });
  constexpr std::size_t kThree = 3;
  if (values.size() == kThree) return {values[0], values[1], values[2]};
  reader.With(object, key, [&](const JsonValue& list) {
    reader.Error(list, Code::kMisfit,
                 "expected a quartile, the median and a quartile");
  });
  return {};
}

RelivedMeasure Unknown() {
  RelivedMeasure one;
  const Quartiles none{kUnknown, kUnknown, kUnknown};
  one.mean = one.own = one.other = kUnknown;
  one.medians = one.losses = none;
  one.best.quartiles = one.best_by_other.quartiles = none;
  return one;
}

RelivedMeasure ReadMeasure(JsonReader& reader, const JsonValue& value) {
  static constexpr std::array<std::string_view, 6> kKnown{
      "mean", "best", "lives", "by_other_engine", "lives_by_other_engine",
      "swap"};
  RelivedMeasure one = Unknown();
  if (!reader.IsObject(value, kKnown)) return one;
  one.mean = reader.NumberIfAny(value, "mean").value_or(kUnknown);
  one.best = {ReadCount(reader, value, "lives"),
              ReadQuartiles(reader, value, "best")};
  if (reader.Has(value, "by_other_engine"))
    one.best_by_other = {ReadCount(reader, value, "lives_by_other_engine"),
                         ReadQuartiles(reader, value, "by_other_engine")};
  if (reader.Has(value, "swap"))
    reader.With(value, "swap", [&](const JsonValue& swap) {
      static constexpr std::array<std::string_view, 3> kSwap{"robots", "own",
                                                             "swapped"};
      if (!reader.IsObject(swap, kSwap)) return;
      one.swapped = ReadCount(reader, swap, "robots");
      one.own = reader.NumberIfAny(swap, "own").value_or(kUnknown);
      one.other = reader.NumberIfAny(swap, "swapped").value_or(kUnknown);
    });
  return one;
}

}  // namespace

nlohmann::ordered_json KeptRelived(const Digest& digest, const DigestRun& one) {
  const RelivedGeneration& generation = one.relived.generation;
  const std::vector<std::string>& seasons = one.reading.population.seasons;
  const std::vector<std::string>& names = RelivedMeasures();
  JsonOut json{{"generation", generation.generation},
               {"best", generation.best},
               {"survivors", generation.survivors},
               {"lives", generation.lives},
               {"swaps", generation.swaps},
               {"lives_by_other_engine", generation.other_lives}};
  JsonOut& measures = json["measures"] = JsonOut::object();
  for (std::size_t measure = 0; measure < names.size(); ++measure) {
    if (!IsKeptRelived(digest, names[measure])) continue;
    for (std::size_t season = 0; season < seasons.size(); ++season)
      measures[names[measure]][seasons[season]] =
          KeptMeasure(generation.of(measure, season));
  }
  return json;
}

RelivedReading ReadKeptRelived(JsonReader& reader, const JsonValue& relived,
                               const std::vector<std::string>& seasons) {
  static constexpr std::array<std::string_view, 7> kKnown{
      "generation", "best",  "survivors",
      "lives",      "swaps", "lives_by_other_engine",
      "measures"};
  RelivedReading reading;
  if (!reader.IsObject(relived, kKnown)) return reading;
  reading.state = RelivedState::kHere;
  RelivedGeneration& generation = reading.generation;
  generation.generation = ReadCount(reader, relived, "generation");
  generation.best = ReadCount(reader, relived, "best");
  generation.survivors = ReadCount(reader, relived, "survivors");
  generation.lives = ReadCount(reader, relived, "lives");
  generation.swaps = ReadCount(reader, relived, "swaps");
  generation.other_lives = ReadCount(reader, relived, "lives_by_other_engine");
  generation.seasons = seasons.size();
  const std::vector<std::string>& names = RelivedMeasures();
  generation.measures.assign(names.size() * seasons.size(), Unknown());
  reader.With(relived, "measures", [&](const JsonValue& measures) {
    const std::vector<std::string_view> known(names.begin(), names.end());
    if (!reader.IsObject(measures, known)) return;
    for (std::size_t measure = 0; measure < names.size(); ++measure) {
      if (!reader.Has(measures, names[measure])) continue;
      reader.With(measures, names[measure], [&](const JsonValue& by_season) {
        for (std::size_t i = 0; i < seasons.size(); ++i)
          reader.With(by_season, seasons[i], [&](const JsonValue& one) {
            generation.measures[measure * seasons.size() + i] =
                ReadMeasure(reader, one);
          });
      });
    }
  });
  return reading;
}

}  // namespace plsc
