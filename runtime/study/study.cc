// An experiment of a study is the base's keys with its own in their place, read
// as one map by the reader of experiments: there is one meaning of each key,
// and a mistake in the base is told once though every experiment reads it. A
// run's seed is a hash of the study's seed and the run's name, not a counter,
// so adding an experiment or repetitions changes no run that there is already.
// A million runs of 64 bits meet with odds of 3e-8.

#include "runtime/study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <unordered_set>
#include <utility>

#include "runtime/study/claim_yaml.h"
#include "runtime/text/key.h"
#include "runtime/text/yaml_reader.h"
#include "runtime/text/yaml_text.h"

namespace plsc {

namespace {

constexpr int kFormat = 1;  // of study files, value of plsc_study
// More is a slip of the pen: a file name and a seed each.
constexpr int kMaxRepetitions = 10'000;
// Of a study, each a file; seeds of more would begin to meet (study.h).
constexpr std::int64_t kMaxRuns = 1'000'000;
// Values of the base times experiments, each of which reads it.
constexpr std::size_t kMaxBaseValues = 1'000'000;

/// Folders are called like experiments.
bool IsFolderName(std::string_view name) {
  constexpr std::string_view kAllowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  return !name.empty() && !name.starts_with('.') &&
         name.find_first_not_of(kAllowed) == std::string_view::npos;
}

/// The entries of an experiment or a base, without those that only an
/// experiment's own file can have.
std::vector<YamlMap::Entry> ExperimentKeys(YamlMap& map) {
  std::vector<YamlMap::Entry> entries;
  for (const YamlMap::Entry& entry : map.TakeAll()) {
    if (entry.key == "seed" || entry.key == "name" ||
        entry.key == "plsc_experiment")
      entry.at.Report(
          Code::kMisfit,
          fmt::format("'{}' is not for experiments of a study", entry.key),
          "every run has a name and a seed that follow from the study's");
    else
      entries.push_back(entry);
  }
  return entries;
}

Experiment ReadMerged(const std::vector<YamlMap::Entry>& base, YamlMap& own) {
  std::vector<YamlMap::Entry> merged = ExperimentKeys(own);
  std::unordered_set<std::string> own_keys;
  for (const YamlMap::Entry& entry : merged) own_keys.insert(entry.key);
  for (const YamlMap::Entry& entry : base)
    if (!own_keys.contains(entry.key)) merged.push_back(entry);
  YamlMap map(own.place(), std::move(merged));
  return ReadExperiment(map);
}

std::vector<StudyExperiment> ReadExperiments(
    const YamlValue& value, const std::vector<YamlMap::Entry>& base) {
  std::vector<StudyExperiment> experiments;
  std::optional<YamlMap> map = value.Map("a map from names to experiments");
  if (!map) return experiments;
  for (const YamlMap::Entry& entry : map->TakeAll()) {
    // A mistake of the base is found in each.
    if (value.is_full()) break;
    if (!IsFolderName(entry.key))
      entry.at.Report(Code::kUnknownWord,
                      fmt::format("expected a name of letters, digits, '_', "
                                  "'-' and '.', found '{}'",
                                  entry.key),
                      "a folder is called like the experiment");
    if (std::optional<YamlMap> own =
            entry.value.Map("keys of an experiment ({} for none)"))
      experiments.push_back({entry.key, ReadMerged(base, *own)});
  }
  if (map->TakeAll().empty())
    value.Report(Code::kMisfit, "expected at least one experiment");
  return experiments;
}

// How much all runs, and all copies of the base, are together.
bool IsTooMuch(const YamlValue& experiments, const Study& study,
               std::size_t base_values) {
  const std::size_t count =
      experiments.is_map() ? experiments.CountEntries() : 0;
  const std::int64_t runs =
      static_cast<std::int64_t>(count) * study.repetitions;
  if (runs > kMaxRuns)
    experiments.Report(
        Code::kMisfit,
        fmt::format("a study has at most {} runs; {} experiments of "
                    "{} repetitions are {}",
                    kMaxRuns, count, study.repetitions, runs));
  else if (base_values * count > kMaxBaseValues)
    experiments.Report(
        Code::kMisfit,
        fmt::format("{} experiments share a base of {} or more values: "
                    "together more than {}",
                    count, base_values, kMaxBaseValues),
        "spread the experiments over several studies");
  else
    return false;
  return true;
}

Study ReadStudy(YamlMap& map) {
  Study study;
  map.Int("plsc_study", kFormat, kFormat, kFormat);
  study.name = map.Text("name", "");
  if (const auto seed = map.Find("seed"))
    study.seed = seed->Unsigned().value_or(study.seed);
  study.repetitions =
      map.Int("repetitions", study.repetitions, 1, kMaxRepetitions);
  std::vector<YamlMap::Entry> base;
  std::size_t base_values = 0;
  if (const auto value = map.Find("base")) {
    base_values = value->CountValues(kMaxBaseValues + 1);
    if (std::optional<YamlMap> keys = value->Map("keys of experiments"))
      base = ExperimentKeys(*keys);
  }
  if (const auto experiments =
          map.Need("experiments",
                   "as in 'experiments: {plastic: {}, baseline: "
                   "{encoding: baseline}}'"))
    if (!IsTooMuch(*experiments, study, base_values))
      study.experiments = ReadExperiments(*experiments, base);
  // Names that are wrong there are unknown here, and told once.
  if (const auto claims = map.Find("claims"))
    study.claims = ReadClaims(
        *claims, study.experiments,
        claims->error_count() > 0 ? ClaimCheck::kWords : ClaimCheck::kNames);
  map.Close();
  return study;
}

/// A mistake of the base is found in every experiment.
std::vector<Diagnostic> WithoutRepetitions(
    const std::vector<Diagnostic>& diagnostics) {
  std::vector<Diagnostic> once;
  for (const Diagnostic& one : diagnostics)
    if (std::none_of(once.begin(), once.end(), [&](const Diagnostic& other) {
          return other.code == one.code && other.message == one.message &&
                 other.span.begin == one.span.begin;
        }))
      once.push_back(one);
  return once;
}

}  // namespace

Result<Study> ParseStudy(const Source& yaml) {
  const YamlFile file(yaml);
  Study study;
  if (std::optional<YamlMap> root = file.Root("a study"))
    study = ReadStudy(*root);
  if (!file.diagnostics().empty())
    return WithoutRepetitions(file.diagnostics());
  return study;
}

std::string PrintStudy(const Study& study) {
  std::string text = fmt::format("plsc_study: {}\n", kFormat);
  if (!study.name.empty())
    text += fmt::format("name: {}\n", PrintYamlText(study.name));
  text += fmt::format("seed: {}\nrepetitions: {}\nexperiments:\n", study.seed,
                      study.repetitions);
  for (const StudyExperiment& one : study.experiments)
    text += fmt::format("  {}:\n{}", PrintYamlText(one.name),
                        PrintExperimentKeys(one.experiment, 4));
  if (!study.claims.empty()) text += "claims:\n" + PrintClaims(study.claims, 2);
  return text;
}

std::vector<StudyRun> RunsOf(const Study& study) {
  std::vector<StudyRun> runs;
  for (std::size_t i = 0; i < study.experiments.size(); ++i)
    for (int repetition = 1; repetition <= study.repetitions; ++repetition)
      runs.push_back({i, repetition});
  return runs;
}

std::string RunName(const Study& study, const StudyRun& run) {
  return fmt::format("{}/{}", study.experiments[run.experiment].name,
                     run.repetition);
}

std::uint64_t SeedOf(const Study& study, const StudyRun& run) {
  return KeyOf(fmt::format("plsc study run\nseed {}\n{}\n", study.seed,
                           RunName(study, run)))
      .high;
}

Experiment ExperimentOf(const Study& study, const StudyRun& run) {
  Experiment experiment = study.experiments[run.experiment].experiment;
  experiment.name = study.name.empty() ? RunName(study, run)
                                       : study.name + " " + RunName(study, run);
  experiment.seed = SeedOf(study, run);
  return experiment;
}

bool HasOwnFitness(const Study& study) {
  return std::any_of(
      study.experiments.begin(), study.experiments.end(),
      [](const StudyExperiment& one) { return HasOwnFitness(one.experiment); });
}

}  // namespace plsc
