#include "runtime/study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "runtime/key.h"
#include "runtime/yaml_reader.h"
#include "runtime/yaml_text.h"

namespace plsc {

namespace {

constexpr int kFormat = 1;  // of study files, value of plsc_study
// More is a slip of the pen: a file name and a seed each.
constexpr int kMaxRepetitions = 10'000;

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
          "P5108",
          fmt::format("'{}' is not for experiments of a study", entry.key),
          "every run has a name and a seed that follow from the study's");
    else
      entries.push_back(entry);
  }
  return entries;
}

Experiment ReadMerged(const std::vector<YamlMap::Entry>& base, YamlMap& own) {
  std::vector<YamlMap::Entry> merged = ExperimentKeys(own);
  const std::size_t count = merged.size();
  for (const YamlMap::Entry& entry : base) {
    const auto end = merged.begin() + static_cast<std::ptrdiff_t>(count);
    if (std::none_of(merged.begin(), end, [&](const YamlMap::Entry& other) {
          return other.key == entry.key;
        }))
      merged.push_back(entry);
  }
  YamlMap map(own.place(), std::move(merged));
  return ReadExperiment(map);
}

std::vector<StudyExperiment> ReadExperiments(
    const YamlValue& value, const std::vector<YamlMap::Entry>& base) {
  std::vector<StudyExperiment> experiments;
  std::optional<YamlMap> map = value.Map("a map from names to experiments");
  if (!map) return experiments;
  for (const YamlMap::Entry& entry : map->TakeAll()) {
    if (!IsFolderName(entry.key))
      entry.at.Report("P5107",
                      fmt::format("expected a name of letters, digits, '_', "
                                  "'-' and '.', found '{}'",
                                  entry.key),
                      "a folder is called like the experiment");
    if (std::optional<YamlMap> own =
            entry.value.Map("keys of an experiment ({} for none)"))
      experiments.push_back({entry.key, ReadMerged(base, *own)});
  }
  if (experiments.empty() && map->TakeAll().empty())
    value.Report("P5108", "expected at least one experiment");
  return experiments;
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
  if (const auto value = map.Find("base"))
    if (std::optional<YamlMap> keys = value->Map("keys of experiments"))
      base = ExperimentKeys(*keys);
  if (const auto experiments =
          map.Need("experiments",
                   "as in 'experiments: {plastic: {}, baseline: "
                   "{encoding: baseline}}'"))
    study.experiments = ReadExperiments(*experiments, base);
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

}  // namespace plsc
