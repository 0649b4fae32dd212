#include "runtime/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

#include "runtime/store/run_store.h"

namespace plsc {

namespace {

/// "tiny plastic/3" to "tiny plastic": runs of studies are named so.
std::string WithoutRepetition(const std::string& name) {
  const std::size_t slash = name.rfind('/');
  if (slash == std::string::npos || slash + 1 == name.size()) return name;
  const bool is_number =
      std::all_of(name.begin() + static_cast<std::ptrdiff_t>(slash) + 1,
                  name.end(), [](unsigned char c) { return std::isdigit(c); });
  return is_number ? name.substr(0, slash) : name;
}

/// What is known of the run; nothing of a file that cannot be read.
std::optional<Experiment> ExperimentOfRun(const ReportRun& run) {
  if (run.input.expected) return run.input.expected;
  if (run.reading.state == RunState::kDamaged ||
      run.reading.state == RunState::kMissing)
    return std::nullopt;
  return run.reading.experiment;
}

std::string UniqueName(const std::vector<ReportExperiment>& experiments,
                       const std::string& wanted) {
  std::string name = wanted;
  for (int number = 2; std::any_of(
           experiments.begin(), experiments.end(),
           [&](const ReportExperiment& one) { return one.name == name; });
       ++number)
    name = fmt::format("{} ({})", wanted, number);
  return name;
}

std::string NameFor(const ReportRun& run, const Experiment& experiment) {
  if (!run.input.experiment.empty()) return run.input.experiment;
  std::string name = WithoutRepetition(experiment.name);
  return name.empty() ? run.input.label : name;
}

std::vector<ReportExperiment> GroupRuns(const std::vector<ReportRun>& runs) {
  std::vector<ReportExperiment> groups;
  std::vector<std::pair<std::string, std::string>> keys;  // name, keys
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::optional<Experiment> experiment = ExperimentOfRun(runs[i]);
    if (!experiment) continue;
    const std::string& named = runs[i].input.experiment;
    // What runs of one experiment have in common.
    const std::string key = PrintExperimentKeys(*experiment, 0);
    std::size_t group = 0;
    while (group < groups.size() &&
           !(keys[group].second == key &&
             (named.empty() || keys[group].first == named)))
      ++group;
    if (group == groups.size()) {
      keys.emplace_back(named, key);
      groups.push_back({UniqueName(groups, NameFor(runs[i], *experiment)),
                        *experiment,
                        {},
                        false,
                        {}});
    }
    groups[group].runs.push_back(i);
  }
  return groups;
}

std::size_t IndexOf(const std::string& season,
                    std::vector<std::string>& seasons) {
  const auto found = std::find(seasons.begin(), seasons.end(), season);
  const auto index = static_cast<std::size_t>(found - seasons.begin());
  if (found == seasons.end()) seasons.push_back(season);
  return index;
}

/// The season of an experiment that is compared whose ground a static one has.
std::string SeasonLike(const Season& season, const StudyReport& report) {
  for (const ReportExperiment& other : report.experiments)
    if (!other.is_static)
      for (const Season& candidate : other.experiment.scenario.seasons)
        if (candidate.terrain == season.terrain) return candidate.name;
  return season.name;
}

void PlaceSeasons(StudyReport& report) {
  const auto is_short = [](const ReportExperiment& one) {
    return one.experiment.scenario.seasons.size() == 1;
  };
  const bool has_long = !std::all_of(report.experiments.begin(),
                                     report.experiments.end(), is_short);
  for (ReportExperiment& one : report.experiments)
    one.is_static = has_long && is_short(one);
  for (const bool is_static : {false, true})
    for (ReportExperiment& one : report.experiments) {
      if (one.is_static != is_static) continue;
      for (const Season& season : one.experiment.scenario.seasons)
        one.seasons.push_back(
            IndexOf(is_static ? SeasonLike(season, report) : season.name,
                    report.seasons));
    }
}

int ComparedGeneration(const StudyReport& report) {
  int compared = -1;
  for (const ReportExperiment& one : report.experiments) {
    int most = 0;
    for (const std::size_t run : one.runs)
      most = std::max(most, report.runs[run].reading.population.generations);
    if (most > 0)
      compared = compared < 0 ? most - 1 : std::min(compared, most - 1);
  }
  return compared;
}

/// Whether any of the runs goes by a formula of its own. Runs that cannot be
/// read tell nothing.
bool HasOwnFitness(const ReportInput& input) {
  if (input.digest) return HasOwnFitness(input.digest->study);
  if (input.expected) return HasOwnFitness(*input.expected);
  RunStore store;
  return !store.OpenForReading(input.path) && HasOwnFitness(store.experiment());
}

void TakeOwnFitness(const ReportInputs& inputs,
                    std::vector<ReportMeasure>& measures) {
  const bool is_asked = std::any_of(measures.begin(), measures.end(),
                                    [](const ReportMeasure& measure) {
                                      return measure.id == kFitnessMeasure;
                                    });
  if (is_asked &&
      std::any_of(inputs.runs.begin(), inputs.runs.end(),
                  [](const ReportInput& one) { return HasOwnFitness(one); }))
    UseOwnFitness(measures);
}

}  // namespace

StudyReport BuildReport(const ReportInputs& inputs,
                        const std::vector<ReportMeasure>& measures,
                        const ReportProgress& on_run, bool verify) {
  StudyReport report;
  report.title = inputs.title;
  report.claims = inputs.claims;
  report.measures = measures;
  for (const StudyClaims& study : inputs.claims)
    AddClaimedMeasures(study.record, report.measures);
  TakeOwnFitness(inputs, report.measures);
  report.is_single = inputs.runs.size() == 1;
  report.is_verified = verify;
  const ReadOptions options{report.measures, report.is_single, verify};
  for (const ReportInput& input : inputs.runs) {
    RunReading reading =
        input.kept != nullptr
            ? ReadingOf(*input.digest, *input.kept, report.measures)
        : input.digest ? RunReading()
                       : ReadRun(input.path, options, input.expected);
    report.is_thinned = report.is_thinned || input.kept != nullptr;
    report.runs.push_back({input, std::move(reading), {}, {}});
    if (on_run) on_run(report.runs.size(), inputs.runs.size());
  }
  report.experiments = GroupRuns(report.runs);
  PlaceSeasons(report);
  report.generation = ComparedGeneration(report);
  return report;
}

void AddRelived(StudyReport& report) {
  for (ReportRun& run : report.runs) {
    if (report.generation < 0 ||
        report.generation >= run.reading.population.generations)
      continue;
    run.relived = run.input.kept != nullptr
                      ? run.input.kept->relived
                      : ReadRelived(run.input.path, report.generation);
    // A digest has those of the last one.
    if (run.relived.state == RelivedState::kHere &&
        run.relived.generation.generation != report.generation)
      run.relived = {RelivedState::kOlder, "", {}};
  }
}

}  // namespace plsc
