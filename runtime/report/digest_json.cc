// The text of a digest. Means go by measure and season, as the figures do, so
// that a reader finds Speed in Flat as series.displacement_velocity_hill.flat;
// generations stand once in a run. What is read is checked, as a digest may
// come from anywhere: runs that the study has, seasons that its experiment has,
// as many numbers as generations.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "compiler/compile.h"
#include "runtime/report/digest.h"
#include "runtime/report/digest_relived_json.h"
#include "runtime/report/rounded_json.h"
#include "runtime/store/schema.h"
#include "runtime/study/claims_record.h"
#include "runtime/text/json_dump.h"
#include "runtime/text/json_reader.h"
#include "runtime/text/json_text.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kDigestVersion = 1;
constexpr double kNotKept = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t kMostInt = std::numeric_limits<int>::max();
constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();

std::vector<int> KeptOf(int generations, int every) {
  std::vector<int> kept;
  for (int generation = 0; generation < generations; ++generation)
    if (IsKept(generation, generations, every)) kept.push_back(generation);
  return kept;
}

/// Of the generations that are kept; or of all, if the curve is needed whole
/// and is there.
Json NumbersJson(const std::vector<double>& values, std::vector<int> kept,
                 bool is_whole) {
  if (is_whole && std::none_of(values.begin(), values.end(),
                               [](double one) { return std::isnan(one); }))
    kept = KeptOf(static_cast<int>(values.size()), 1);
  Json json = Json::array();
  for (const int generation : kept)
    json.push_back(RoundedNumber(values[static_cast<std::size_t>(generation)]));
  return json;
}

/// Whether it is claimed when the curve is at its lowest, which a gap hides.
bool IsCourse(const std::vector<Claim>& claims, const std::string& experiment,
              const ReportMeasure& measure, const std::string& season,
              ClaimOf of) {
  return std::any_of(claims.begin(), claims.end(), [&](const Claim& claim) {
    return claim.kind == ClaimKind::kMinimumBefore && claim.of == of &&
           claim.measure == MeasureName(measure) &&
           claim.experiments.front() == experiment &&
           claim.seasons.front() == season;
  });
}

Json KeptSeries(const Digest& digest, const std::vector<Claim>& claims,
                const DigestRun& one, const std::vector<int>& kept) {
  const PopulationSummary& population = one.reading.population;
  const std::string& experiment =
      digest.study.experiments[one.run.experiment].name;
  Json json = Json::object();
  for (std::size_t i = 0; i < digest.measures.size(); ++i) {
    const ReportMeasure& measure = digest.measures[i];
    Json& seasons = json[measure.id];
    for (std::size_t season = 0; season < population.seasons.size(); ++season) {
      const Series& series = population.of(i, season);
      const auto numbers = [&](const std::vector<double>& values, ClaimOf of) {
        return NumbersJson(values, kept,
                           IsCourse(claims, experiment, measure,
                                    population.seasons[season], of));
      };
      seasons[population.seasons[season]] = {
          {"mean", numbers(series.means, ClaimOf::kMean)},
          {"best", numbers(series.best, ClaimOf::kBest)}};
    }
  }
  return json;
}

/// By the columns of a store, as `generation` has them.
Json KeptCensuses(const std::vector<CensusCounts>& censuses,
                  const std::vector<int>& kept) {
  const std::vector<std::string> names = CensusColumns();
  Json json = Json::object();
  for (std::size_t i = 0; i < names.size(); ++i) {
    Json& numbers = json[names[i]] = Json::array();
    for (const int generation : kept)
      numbers.push_back(
          List(censuses[static_cast<std::size_t>(generation)])[i]);
  }
  return json;
}

Json KeptErrors(const std::vector<SeasonErrors>& errors) {
  Json json = Json::array();
  for (const SeasonErrors& one : errors)
    json.push_back({{"median", RoundedNumber(one.median)},
                    {"worst", RoundedNumber(one.worst)}});
  return json;
}

Json KeptVersions(const Versions& versions) {
  return {{"plsc", versions.plsc},
          {"results", versions.results},
          {"ode", versions.ode},
          {"compiler", versions.compiler},
          {"machine", versions.machine}};
}

Json KeptWork(const WorkDone& work) {
  return {{"first", work.first},
          {"last", work.last},
          {"cpu_seconds", RoundedNumber(work.cpu_seconds)},
          {"simulated", work.simulated},
          {"looked_up", work.looked_up}};
}

Json KeptRun(const Digest& digest, const std::vector<Claim>& claims,
             const DigestRun& one) {
  const RunReading& reading = one.reading;
  const std::vector<int> kept =
      KeptOf(reading.population.generations, digest.every);
  Json json{{"experiment", digest.study.experiments[one.run.experiment].name},
            {"repetition", one.run.repetition},
            {"seed", reading.facts.seed},
            {"command", CommandFor(digest.study, one.run)},
            {"versions", KeptVersions(reading.facts.versions)},
            {"work", KeptWork(reading.facts.work)},
            {"evaluations", reading.facts.evaluations},
            {"generations", kept},
            {"series", KeptSeries(digest, claims, one, kept)}};
  json["census"] = KeptCensuses(reading.population.censuses, kept);
  json["servo_errors"] = KeptErrors(reading.population.errors);
  json["relived"] = one.relived.state == RelivedState::kHere
                        ? KeptRelived(digest, one)
                        : Json(nullptr);
  json["best"] = {{"id", reading.facts.best}, {"genotype", one.genotype}};
  return json;
}

/// Values by generation, from those of some generations.
class GenerationsReader {
 public:
  GenerationsReader(JsonReader& reader, const JsonValue& run, int generations)
      : reader_(reader), generations_(generations) {
    reader.List(run, "generations", [&](const JsonValue& one) {
      const auto next =
          static_cast<int>(reader.Integer(one, 0, generations - 1));
      if (!kept_.empty() && next <= kept_.back())
        reader.Error(one, Code::kMisfit, "generations do not rise");
      kept_.push_back(next);
    });
  }

  /// Curves that something is claimed of may be whole.
  std::vector<double> Read(const JsonValue& object, std::string_view key,
                           bool may_be_whole) {
    std::vector<double> values(static_cast<std::size_t>(generations_),
                               kNotKept);
    std::vector<double> read;
    reader_.List(object, key, [&](const JsonValue& one) {
      read.push_back(one.json.is_null() ? kNotKept : reader_.Number(one));
    });
    if (may_be_whole && read.size() == values.size()) return read;
    if (read.size() != kept_.size())
      reader_.Error(object, Code::kMisfit,
                    fmt::format("expected {} numbers for '{}', one a "
                                "generation, found {}",
                                kept_.size(), key, read.size()));
    for (std::size_t i = 0; i < std::min(read.size(), kept_.size()); ++i)
      values[static_cast<std::size_t>(kept_[i])] = read[i];
    return values;
  }

 private:
  JsonReader& reader_;
  int generations_;
  std::vector<int> kept_;
};

Series ReadSeries(JsonReader& reader, const JsonValue& value,
                  GenerationsReader& generations) {
  static constexpr std::array<std::string_view, 2> kKnown{"mean", "best"};
  Series series;
  if (!reader.IsObject(value, kKnown)) return series;
  series.means = generations.Read(value, "mean", true);
  series.best = generations.Read(value, "best", true);
  return series;
}

/// Counts by generation; 0 where one was not kept.
std::vector<std::int64_t> ReadCounts(JsonReader& reader,
                                     const JsonValue& census,
                                     const std::string& name,
                                     GenerationsReader& generations) {
  reader.List(census, name,
              [&](const JsonValue& one) { reader.Integer(one, 0, kMostInt); });
  std::vector<std::int64_t> counts;
  for (const double value : generations.Read(census, name, false))
    counts.push_back(
        value >= 0 && value <= kMostInt ? static_cast<std::int64_t>(value) : 0);
  return counts;
}

std::vector<CensusCounts> ReadCensuses(JsonReader& reader,
                                       const JsonValue& census,
                                       GenerationsReader& generations) {
  std::vector<std::vector<std::int64_t>> columns;
  for (const std::string& name : CensusColumns())
    columns.push_back(ReadCounts(reader, census, name, generations));
  std::vector<CensusCounts> censuses(columns.front().size());
  for (std::size_t i = 0; i < censuses.size(); ++i)
    censuses[i] = {columns[0][i], columns[1][i], columns[2][i], columns[3][i],
                   columns[4][i], columns[5][i], columns[6][i], columns[7][i]};
  return censuses;
}

void ReadPopulation(JsonReader& reader, const JsonValue& run,
                    const Digest& digest, const Experiment& experiment,
                    PopulationSummary& population) {
  population.generations = experiment.generations;
  for (const Season& season : experiment.scenario.seasons)
    population.seasons.push_back(season.name);
  GenerationsReader generations(reader, run, experiment.generations);
  reader.With(run, "series", [&](const JsonValue& all) {
    for (const ReportMeasure& measure : digest.measures)
      reader.With(all, measure.id, [&](const JsonValue& seasons) {
        for (const std::string& season : population.seasons)
          reader.With(seasons, season, [&](const JsonValue& one) {
            population.series.push_back(ReadSeries(reader, one, generations));
          });
      });
  });
  reader.With(run, "census", [&](const JsonValue& census) {
    population.censuses = ReadCensuses(reader, census, generations);
  });
  reader.List(run, "servo_errors", [&](const JsonValue& one) {
    population.errors.push_back(
        {reader.NumberIfAny(one, "median").value_or(kNotKept),
         reader.NumberIfAny(one, "worst").value_or(kNotKept)});
  });
}

Versions ReadVersions(JsonReader& reader, const JsonValue& value) {
  return {reader.Text(value, "plsc"), reader.Text(value, "ode"),
          reader.Text(value, "compiler"), reader.Text(value, "machine"),
          static_cast<int>(reader.Integer(value, "results", 0, kMostInt))};
}

WorkDone ReadWork(JsonReader& reader, const JsonValue& value) {
  WorkDone work;
  work.first = reader.Text(value, "first");
  work.last = reader.Text(value, "last");
  work.cpu_seconds = reader.Number(value, "cpu_seconds");
  work.simulated = reader.Integer(value, "simulated", 0, kMost);
  work.looked_up = reader.Integer(value, "looked_up", 0, kMost);
  return work;
}

/// Which run of the study; an error if it has none like this.
std::optional<StudyRun> ReadPlace(JsonReader& reader, const JsonValue& value,
                                  const Study& study) {
  const std::string name = reader.Text(value, "experiment");
  StudyRun run;
  run.repetition = static_cast<int>(
      reader.Integer(value, "repetition", 1, study.repetitions));
  for (const StudyExperiment& one : study.experiments) {
    if (one.name == name) return run;
    ++run.experiment;
  }
  reader.Error(value, Code::kUnknownWord,
               fmt::format("the study has no experiment '{}'", name));
  return std::nullopt;
}

void ReadKept(JsonReader& reader, const JsonValue& value, Digest& digest) {
  static constexpr std::array<std::string_view, 13> kKnown{
      "experiment",   "repetition",  "seed",        "command", "versions",
      "work",         "evaluations", "generations", "series",  "census",
      "servo_errors", "relived",     "best"};
  if (!reader.IsObject(value, kKnown)) return;
  const std::optional<StudyRun> place = ReadPlace(reader, value, digest.study);
  if (!place) return;
  if (std::any_of(digest.runs.begin(), digest.runs.end(),
                  [&](const DigestRun& other) { return other.run == *place; }))
    reader.Error(
        value, Code::kMisfit,
        fmt::format("{} is there twice", RunName(digest.study, *place)));
  DigestRun one{*place, "", {}};
  RunReading& reading = one.reading;
  reading.state = RunState::kDone;
  reading.experiment = ExperimentOf(digest.study, *place);
  RunFacts& facts = reading.facts;
  facts.name = reading.experiment.name;
  facts.seed = reader.Text(value, "seed");
  if (facts.seed != std::to_string(reading.experiment.seed))
    reader.Error(
        value, Code::kMisfit,
        fmt::format("the study's run {} has the seed {}",
                    RunName(digest.study, *place), reading.experiment.seed));
  facts.planned_generations = reading.experiment.generations;
  facts.planned_evaluations = Evaluations(reading.experiment);
  facts.evaluations = reader.Integer(value, "evaluations", 0, kMost);
  reader.With(value, "versions", [&](const JsonValue& versions) {
    facts.versions = ReadVersions(reader, versions);
  });
  reader.With(value, "work", [&](const JsonValue& work) {
    facts.work = ReadWork(reader, work);
  });
  reader.With(value, "best", [&](const JsonValue& best) {
    facts.best = static_cast<int>(reader.Integer(best, "id", 1, kMostInt));
    one.genotype = reader.Text(best, "genotype");
    if (!Compile(Source("genotype", one.genotype)))
      reader.Error(best, Code::kMisfit, "'genotype' does not compile");
  });
  ReadPopulation(reader, value, digest, reading.experiment, reading.population);
  // A digest may be of a time when none were kept.
  if (reader.Has(value, "relived"))
    reader.With(value, "relived", [&](const JsonValue& relived) {
      if (!relived.json.is_null())
        one.relived =
            ReadKeptRelived(reader, relived, reading.population.seasons);
    });
  if (reader.errors().empty()) AddRun(std::move(one), digest);
}

void ReadClaimsTexts(JsonReader& reader, const JsonValue& root,
                     Digest& digest) {
  // A digest may be of a time when none were kept.
  if (!root.json.contains("claims")) return;
  reader.List(root, "claims", [&](const JsonValue& text) {
    digest.claims.push_back(reader.Text(text));
  });
  const auto record = ParseClaimsRecord(digest.claims, "the study");
  if (!record)
    reader.Error(JsonValue{root.json["claims"], &root, "claims"}, Code::kMisfit,
                 record.error().text);
}

}  // namespace

std::string PrintDigest(const Digest& digest) {
  // By hand where lines matter: a run a line is what version control compares.
  std::string text =
      fmt::format("{{\"plsc_digest\":{},\n\"study\":{},\n", kDigestVersion,
                  DumpJson(Json(PrintStudy(digest.study))));
  Json measures = Json::array();
  for (const ReportMeasure& one : digest.measures) measures.push_back(one.id);
  text += fmt::format(
      "\"claims\":{},\n\"measures\":{},\n\"every\":{},\n\"runs\":[",
      DumpJson(Json(digest.claims)), DumpJson(measures), digest.every);
  std::vector<Claim> claims;
  if (const auto record = ParseClaimsRecord(digest.claims, "the study"))
    for (const StatedClaim& one : StatedClaims(*record))
      claims.push_back(one.claim);
  const char* separator = "\n";
  for (const DigestRun& one : digest.runs) {
    text += separator + DumpJson(KeptRun(digest, claims, one));
    separator = ",\n";
  }
  return text + "\n]}\n";
}

Result<Digest> ParseDigest(const Source& source) {
  static constexpr std::array<std::string_view, 6> kKnown{
      "plsc_digest", "study", "claims", "measures", "every", "runs"};
  const Result<nlohmann::json> json = ReadJson(source);
  if (!json) return json.diagnostics();
  JsonReader reader(source);
  const JsonValue root{*json, nullptr, ""};
  Digest digest;
  if (!root.json.is_object()) {
    reader.Wrong(root, "an object");
    return reader.errors();
  }
  if (!reader.IsReadable(root, "plsc_digest", kDigestVersion, "digest") ||
      !reader.IsObject(root, kKnown))
    return reader.errors();
  const Result<Study> study =
      ParseStudy(Source("study", reader.Text(root, "study")));
  if (!study) {
    reader.Error(JsonValue{root.json["study"], &root, "study"}, Code::kMisfit,
                 "the study in this digest cannot be read: " +
                     study.diagnostics().front().message);
    return reader.errors();
  }
  digest.study = *study;
  ReadClaimsTexts(reader, root, digest);
  digest.every = static_cast<int>(reader.Integer(root, "every", 1, kMostInt));
  reader.List(root, "measures", [&](const JsonValue& measure) {
    auto found = ChooseMeasures(reader.Text(measure));
    if (found && HasOwnFitness(digest.study)) UseOwnFitness(*found);
    if (!found || found->size() != 1)
      reader.Error(measure, Code::kUnknownWord, "no measure has this name");
    else if (std::find(digest.measures.begin(), digest.measures.end(),
                       found->front()) != digest.measures.end())
      reader.Error(measure, Code::kMisfit, "a measure is there twice");
    else
      digest.measures.push_back(found->front());
  });
  if (!reader.errors().empty()) return reader.errors();
  reader.List(root, "runs",
              [&](const JsonValue& run) { ReadKept(reader, run, digest); });
  if (!reader.errors().empty()) return reader.errors();
  return digest;
}

}  // namespace plsc
