// The text of a digest. Means go by measure and season, as the figures do, so
// that a reader finds Speed in Flat as series.displacement_velocity_hill.flat;
// generations stand once in a run. What is read is checked, as a digest may
// come from anywhere: runs that the study has, seasons that its experiment has,
// as many numbers as generations.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "grammar/number.h"
#include "runtime/report/digest.h"
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
constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();

std::vector<int> KeptOf(int generations, int every) {
  std::vector<int> kept;
  for (int generation = 0; generation < generations; ++generation)
    if (IsKept(generation, generations, every)) kept.push_back(generation);
  return kept;
}

Json NumbersJson(const std::vector<double>& values,
                 const std::vector<int>& kept) {
  Json json = Json::array();
  for (const int generation : kept)
    json.push_back(RoundedNumber(values[static_cast<std::size_t>(generation)]));
  return json;
}

Json KeptSeries(const Digest& digest, const PopulationSummary& population,
                const std::vector<int>& kept) {
  Json json = Json::object();
  for (std::size_t measure = 0; measure < digest.measures.size(); ++measure) {
    Json& seasons = json[digest.measures[measure].id];
    for (std::size_t season = 0; season < population.seasons.size(); ++season) {
      const Series& series = population.of(measure, season);
      seasons[population.seasons[season]] = {
          {"mean", NumbersJson(series.means, kept)},
          {"best", NumbersJson(series.best, kept)}};
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

Json KeptRun(const Digest& digest, const DigestRun& one) {
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
            {"series", KeptSeries(digest, reading.population, kept)}};
  json["census"] = KeptCensuses(reading.population.censuses, kept);
  json["servo_errors"] = KeptErrors(reading.population.errors);
  json["best"] = {{"id", reading.facts.best}, {"genotype", one.genotype}};
  return json;
}

/// Values by generation, from those of some generations.
class GenerationsReader {
 public:
  GenerationsReader(JsonReader& reader, const JsonValue& run, int generations)
      : reader_(reader), generations_(generations) {
    reader.List(run, "generations", [&](const JsonValue& one) {
      kept_.push_back(
          static_cast<int>(reader.Integer(one, 0, generations - 1)));
    });
  }

  std::vector<double> Read(const JsonValue& object, std::string_view key) {
    std::vector<double> values(static_cast<std::size_t>(generations_),
                               kNotKept);
    std::size_t count = 0;
    reader_.List(object, key, [&](const JsonValue& one) {
      if (count < kept_.size() && !one.json.is_null())
        values[static_cast<std::size_t>(kept_[count])] = reader_.Number(one);
      ++count;
    });
    if (count != kept_.size())
      reader_.Error(object, Code::kMisfit,
                    fmt::format("expected {} numbers for '{}', one a "
                                "generation, found {}",
                                kept_.size(), key, count));
    return values;
  }

 private:
  JsonReader& reader_;
  int generations_;
  std::vector<int> kept_;
};

template <typename Read>
void With(JsonReader& reader, const JsonValue& object, std::string_view key,
          Read read) {
  if (const nlohmann::json* member = reader.Member(object, key))
    read(JsonValue{*member, &object, std::string(key)});
}

Series ReadSeries(JsonReader& reader, const JsonValue& value,
                  GenerationsReader& generations) {
  static constexpr std::array<std::string_view, 2> kKnown{"mean", "best"};
  Series series;
  if (!reader.IsObject(value, kKnown)) return series;
  series.means = generations.Read(value, "mean");
  series.best = generations.Read(value, "best");
  return series;
}

std::vector<CensusCounts> ReadCensuses(const JsonValue& value,
                                       GenerationsReader& generations) {
  std::vector<std::vector<double>> columns;
  for (const std::string& name : CensusColumns())
    columns.push_back(generations.Read(value, name));
  std::vector<CensusCounts> censuses(columns.front().size());
  for (std::size_t i = 0; i < censuses.size(); ++i) {
    std::array<std::int64_t, 8> counts{};
    for (std::size_t k = 0; k < counts.size(); ++k)
      // None, where a generation was not kept.
      if (std::abs(columns[k][i]) < 1e15)
        counts[k] = static_cast<std::int64_t>(columns[k][i]);
    censuses[i] = {counts[0], counts[1], counts[2], counts[3],
                   counts[4], counts[5], counts[6], counts[7]};
  }
  return censuses;
}

/// No number for null.
double ReadOptional(JsonReader& reader, const JsonValue& object,
                    std::string_view key) {
  const nlohmann::json* member = reader.Member(object, key);
  return member == nullptr || member->is_null()
             ? kNotKept
             : reader.Number(JsonValue{*member, &object, std::string(key)});
}

void ReadPopulation(JsonReader& reader, const JsonValue& run,
                    const Digest& digest, const Experiment& experiment,
                    PopulationSummary& population) {
  population.generations = experiment.generations;
  for (const Season& season : experiment.scenario.seasons)
    population.seasons.push_back(season.name);
  GenerationsReader generations(reader, run, experiment.generations);
  With(reader, run, "series", [&](const JsonValue& all) {
    for (const ReportMeasure& measure : digest.measures)
      With(reader, all, measure.id, [&](const JsonValue& seasons) {
        for (const std::string& season : population.seasons)
          With(reader, seasons, season, [&](const JsonValue& one) {
            population.series.push_back(ReadSeries(reader, one, generations));
          });
      });
  });
  With(reader, run, "census", [&](const JsonValue& census) {
    population.censuses = ReadCensuses(census, generations);
  });
  reader.List(run, "servo_errors", [&](const JsonValue& one) {
    population.errors.push_back({ReadOptional(reader, one, "median"),
                                 ReadOptional(reader, one, "worst")});
  });
}

Versions ReadVersions(JsonReader& reader, const JsonValue& value) {
  return {reader.Text(value, "plsc"), reader.Text(value, "ode"),
          reader.Text(value, "compiler"), reader.Text(value, "machine"),
          static_cast<int>(reader.Integer(value, "results", 0, 1 << 30))};
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
  static constexpr std::array<std::string_view, 12> kKnown{
      "experiment", "repetition", "seed",         "command",
      "versions",   "work",       "evaluations",  "generations",
      "series",     "census",     "servo_errors", "best"};
  if (!reader.IsObject(value, kKnown)) return;
  const std::optional<StudyRun> place = ReadPlace(reader, value, digest.study);
  if (!place) return;
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
  With(reader, value, "versions", [&](const JsonValue& versions) {
    facts.versions = ReadVersions(reader, versions);
  });
  With(reader, value, "work",
       [&](const JsonValue& work) { facts.work = ReadWork(reader, work); });
  With(reader, value, "best", [&](const JsonValue& best) {
    facts.best = static_cast<int>(reader.Integer(best, "id", 1, 1 << 30));
    one.genotype = reader.Text(best, "genotype");
  });
  ReadPopulation(reader, value, digest, reading.experiment, reading.population);
  if (reader.errors().empty()) AddRun(std::move(one), digest);
}

bool IsOfThisVersion(JsonReader& reader, const JsonValue& root) {
  const auto version = reader.Integer(root, "plsc_digest", 1, 1 << 30);
  if (version > kDigestVersion)
    reader.Error(JsonValue{root.json["plsc_digest"], &root, "plsc_digest"},
                 Code::kNewerVersion,
                 fmt::format("this digest is of version {}, and this plsc "
                             "reads version {}",
                             version, kDigestVersion),
                 "use a newer plsc");
  return reader.errors().empty();
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
  const char* separator = "\n";
  for (const DigestRun& one : digest.runs) {
    text += separator + DumpJson(KeptRun(digest, one));
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
  if (!IsOfThisVersion(reader, root) || !reader.IsObject(root, kKnown))
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
  digest.every = static_cast<int>(reader.Integer(root, "every", 1, 1 << 30));
  reader.List(root, "measures", [&](const JsonValue& measure) {
    const auto found = ChooseMeasures(reader.Text(measure));
    if (found && found->size() == 1)
      digest.measures.push_back(found->front());
    else
      reader.Error(measure, Code::kUnknownWord, "no measure has this name");
  });
  if (!reader.errors().empty()) return reader.errors();
  reader.List(root, "runs",
              [&](const JsonValue& run) { ReadKept(reader, run, digest); });
  if (!reader.errors().empty()) return reader.errors();
  return digest;
}

}  // namespace plsc
