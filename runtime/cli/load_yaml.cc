#include "runtime/cli/load_yaml.h"

#include <fmt/format.h>

#include <filesystem>
#include <ostream>

#include "grammar/shown_line.h"

namespace plsc::cli {

namespace {

std::optional<Source> Load(const std::string& path, Io& io) {
  Result<Source> source = ReadSource(path, io);
  if (source) return std::move(*source);
  io.err << fmt::format("error[{}]: {}\n", source.diagnostics()[0].code,
                        Escaped(source.diagnostics()[0].message));
  return std::nullopt;
}

/// Puts the scenario of the file that the experiment names into it, and checks
/// that every season answers every state.
bool CompleteScenario(Experiment& experiment, const std::string& path, Io& io) {
  if (!experiment.scenario_file.empty()) {
    const auto folder = std::filesystem::path(path).parent_path();
    const auto scenario =
        LoadScenario((folder / experiment.scenario_file).string(), io);
    if (!scenario) return false;
    experiment.scenario = *scenario;
  }
  const std::vector<Diagnostic> problems = CheckSenses(experiment);
  for (const Diagnostic& problem : problems)
    io.err << fmt::format("error[{}]: {}\n  = help: {}\n", problem.code,
                          Escaped(problem.message), Escaped(problem.help));
  return problems.empty();
}

}  // namespace

std::optional<Scenario> LoadScenario(const std::string& path, Io& io) {
  if (path.empty()) return PaperScenario();
  const std::optional<Source> source = Load(path, io);
  if (!source) return std::nullopt;
  Result<Scenario> scenario = ParseScenario(*source);
  Report(scenario.diagnostics(), *source, io);
  if (!scenario) return std::nullopt;
  return std::move(*scenario);
}

std::optional<Experiment> LoadExperiment(const std::string& path, Io& io) {
  const std::optional<Source> source = Load(path, io);
  if (!source) return std::nullopt;
  Result<Experiment> experiment = ParseExperiment(*source);
  Report(experiment.diagnostics(), *source, io);
  if (!experiment) return std::nullopt;
  if (!CompleteScenario(*experiment, path, io)) return std::nullopt;
  return std::move(*experiment);
}

std::optional<Study> LoadStudy(const std::string& path, Io& io) {
  const std::optional<Source> source = Load(path, io);
  if (!source) return std::nullopt;
  Result<Study> study = ParseStudy(*source);
  Report(study.diagnostics(), *source, io);
  if (!study) return std::nullopt;
  for (StudyExperiment& one : study->experiments) {
    if (!CompleteScenario(one.experiment, path, io)) return std::nullopt;
    one.experiment.scenario_file.clear();
  }
  return std::move(*study);
}

}  // namespace plsc::cli
