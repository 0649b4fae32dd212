#include "runtime/cli/files/load_yaml.h"

#include <fmt/format.h>

#include <filesystem>
#include <ostream>
#include <utility>

#include "grammar/shown_line.h"
#include "runtime/scenario/scenario_fitness.h"
#include "runtime/scenario/scenario_physics.h"
#include "runtime/scenario/scenario_profile.h"
#include "runtime/scenario/scenario_yaml.h"
#include "runtime/study/claim_yaml.h"

namespace plsc::cli {

namespace {

void Report(const Findings& findings, Io& io) {
  for (const CheckedFile& file : findings)
    Report(file.diagnostics, file.source, io);
}

template <typename T>
std::optional<T> Noted(Result<T> result, const Source& source,
                       Findings& findings) {
  if (!result.diagnostics().empty())
    findings.push_back({source, result.diagnostics()});
  if (!result) return std::nullopt;
  return std::move(*result);
}

/// Where the text names the file.
Span PlaceOf(const std::string& file, const Source& source) {
  const std::size_t at = source.text().find(file);
  if (at == std::string_view::npos) return {};
  return {static_cast<std::uint32_t>(at),
          static_cast<std::uint32_t>(at + file.size())};
}

/// Puts the scenario of the file that the experiment names into it, and checks
/// that every season answers every state.
bool CompleteScenario(Experiment& experiment, const Source& source,
                      Findings& findings, Io& io) {
  // One inside the experiment is checked already.
  if (experiment.scenario_file.empty()) return true;
  const Span place = PlaceOf(experiment.scenario_file, source);
  const auto folder = std::filesystem::path(source.name()).parent_path();
  Result<Source> text =
      ReadSource((folder / experiment.scenario_file).string(), io);
  if (!text) {
    Diagnostic problem = text.diagnostics()[0];
    problem.span = place;
    findings.push_back({source, {std::move(problem)}});
    return false;
  }
  auto scenario =
      ReadScenarioText(*text, findings, experiment.scenario.profile);
  if (!scenario) return false;
  // Of the experiment, for all seasons.
  const std::optional<Formula> fitness =
      experiment.scenario.seasons.front().fitness;
  std::vector<Diagnostic> problems;
  if (fitness && HasOwnFitness(*scenario))
    problems.push_back({Code::kMisfit,
                        {},
                        "fitness is given in this file and in its own, too"});
  experiment.scenario = std::move(*scenario);
  if (fitness)
    for (Season& season : experiment.scenario.seasons) season.fitness = fitness;
  if (problems.empty()) problems = CheckSenses(experiment);
  if (problems.empty()) return true;
  for (Diagnostic& problem : problems) problem.span = place;
  findings.push_back({source, std::move(problems)});
  return false;
}

/// Of seasons that came from files of their own.
bool ClaimsFit(const Study& study, const Source& source, Findings& findings) {
  std::vector<Diagnostic> problems =
      CheckClaims(study.claims, study.experiments);
  if (problems.empty()) return true;
  const Span place = PlaceOf("claims", source);
  for (Diagnostic& problem : problems) problem.span = place;
  findings.push_back({source, std::move(problems)});
  return false;
}

}  // namespace

std::optional<Scenario> ReadScenarioText(const Source& source,
                                         Findings& findings, Profile profile) {
  return Noted(ParseScenario(source, profile), source, findings);
}

std::optional<Experiment> ReadExperimentText(const Source& source,
                                             Findings& findings, Io& io) {
  auto experiment = Noted(ParseExperiment(source), source, findings);
  if (!experiment || !CompleteScenario(*experiment, source, findings, io))
    return std::nullopt;
  return experiment;
}

std::optional<Study> ReadStudyText(const Source& source, Findings& findings,
                                   Io& io) {
  auto study = Noted(ParseStudy(source), source, findings);
  if (!study) return std::nullopt;
  for (StudyExperiment& one : study->experiments) {
    if (!CompleteScenario(one.experiment, source, findings, io))
      return std::nullopt;
    one.experiment.scenario_file.clear();
  }
  if (!ClaimsFit(*study, source, findings)) return std::nullopt;
  return study;
}

std::optional<Scenario> LoadScenario(const std::string& path, Io& io) {
  if (path.empty()) return PaperScenario();
  const std::optional<Source> source = ReadOrReport(path, io);
  if (!source) return std::nullopt;
  Findings findings;
  auto scenario = ReadScenarioText(*source, findings);
  Report(findings, io);
  return scenario;
}

bool UseEngine(std::optional<EngineKind> engine, Scenario& scenario, Io& io) {
  if (!engine) return true;
  const auto problem = SetEngine(scenario, *engine);
  if (problem)
    io.err << fmt::format("error: --engine {}: {}\n   = help: {}\n",
                          NameIn(kEngineNames, *engine),
                          Escaped(problem->message), problem->help);
  return !problem;
}

void MentionSwift(const Scenario& scenario, Io& io) {
  Scenario swift = scenario;
  if (!UsesOde(scenario) || SetEngine(swift, EngineKind::kArticulated)) return;
  io.err << "note: robots live in ODE; with 'profile: swift' (or --engine "
            "articulated) they live by the same physics in a tenth of the "
            "time (docs/simulation.md)\n";
}

std::optional<Experiment> LoadExperiment(const std::string& path, Io& io) {
  const std::optional<Source> source = ReadOrReport(path, io);
  if (!source) return std::nullopt;
  Findings findings;
  auto experiment = ReadExperimentText(*source, findings, io);
  Report(findings, io);
  return experiment;
}

std::optional<Study> LoadStudy(const std::string& path, Io& io) {
  const std::optional<Source> source = ReadOrReport(path, io);
  if (!source) return std::nullopt;
  Findings findings;
  auto study = ReadStudyText(*source, findings, io);
  Report(findings, io);
  return study;
}

}  // namespace plsc::cli
