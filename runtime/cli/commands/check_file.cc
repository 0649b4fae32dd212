#include "runtime/cli/commands/check_file.h"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "compiler/compile.h"
#include "grammar/shown_line.h"
#include "runtime/advice/lint.h"
#include "runtime/cli/files/file_kind.h"
#include "runtime/compare/golden_json.h"
#include "runtime/evolve/trials_yaml.h"
#include "runtime/recording/recording_json.h"
#include "runtime/report/digest.h"
#include "runtime/scenario/scenario_fitness.h"

namespace plsc::cli {

namespace {

std::string Plural(std::int64_t count, std::string_view one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

// " small", or nothing.
std::string Named(const std::string& name) {
  return name.empty() ? "" : " " + name;
}

std::string ContentsOf(const std::vector<MappedProgram>& programs,
                       const std::string& name) {
  std::string text;
  for (const MappedProgram& mapped : programs) {
    const Program& program = mapped.program;
    text += fmt::format(
        "{}: genotype {}, alphabet {}, {} rules, {} states, {} environments",
        name, program.genotype.name, program.genotype.alphabet->name(),
        program.genotype.rules.size(), program.genotype.states.size(),
        program.environments.size());
    if (!program.tests.empty())
      text += fmt::format(", {} tests", program.tests.size());
    text += '\n';
  }
  return text;
}

std::string SeasonsOf(const Scenario& scenario) {
  double seconds = 0;
  for (const Season& season : scenario.seasons) seconds += season.duration;
  return fmt::format(
      "{}, {} s",
      Plural(static_cast<std::int64_t>(scenario.seasons.size()), "season"),
      seconds);
}

std::string ContentsOf(const Experiment& experiment) {
  const std::string trials = DescribeTrials(experiment.trials);
  const bool is_own = HasOwnFitness(experiment.scenario);
  return fmt::format(
      "experiment{}, population {} + {}, {}, {}, {}{}{}{}{}",
      Named(experiment.name), experiment.population, experiment.offspring,
      Plural(experiment.generations, "generation"),
      Plural(Evaluations(experiment), "robot"), SeasonsOf(experiment.scenario),
      trials.empty() ? "" : ", ", trials, is_own ? ", fitness " : "",
      is_own ? Escaped(DescribeFitness(experiment.scenario)) : "");
}

std::string ContentsOf(const Study& study) {
  std::int64_t robots = 0;
  for (const StudyExperiment& one : study.experiments)
    robots += Evaluations(one.experiment) * study.repetitions;
  const auto experiments = static_cast<std::int64_t>(study.experiments.size());
  const auto claims = static_cast<std::int64_t>(study.claims.size());
  return fmt::format("study{}, {}, {} each, {}{}", Named(study.name),
                     Plural(experiments, "experiment"),
                     Plural(study.repetitions, "run"), Plural(robots, "robot"),
                     claims > 0 ? ", " + Plural(claims, "claim") : "");
}

std::string ContentsOf(const Scenario& scenario) {
  return fmt::format("scenario{}, {}", Named(scenario.name),
                     SeasonsOf(scenario));
}

std::string ContentsOf(const Golden& golden) {
  return fmt::format(
      "golden file of {}",
      Plural(static_cast<std::int64_t>(golden.cases.size()), "environment"));
}

std::string ContentsOf(const Recording& recording) {
  return fmt::format(
      "recording of {}, {}", recording.name,
      Plural(static_cast<std::int64_t>(recording.seasons.size()), "season"));
}

std::string ContentsOf(const Digest& digest) {
  return fmt::format(
      "digest of {} of {}, {}",
      Plural(static_cast<std::int64_t>(digest.runs.size()), "run"),
      RunsOf(digest.study).size(), ContentsOf(digest.study));
}

template <typename T>
void Take(const std::optional<T>& read, const Source& source,
          FileCheck& check) {
  check.is_fine = read.has_value();
  if (read)
    check.contents =
        fmt::format("{}: {}\n", Escaped(source.name()), ContentsOf(*read));
}

template <typename T>
void Take(const Result<T>& read, const Source& source, FileCheck& check) {
  check.findings.push_back({source, read.diagnostics()});
  check.is_fine = static_cast<bool>(read);
  if (read)
    check.contents =
        fmt::format("{}: {}\n", Escaped(source.name()), ContentsOf(*read));
}

void CheckGenotype(const Source& source, const CheckCommand& command,
                   FileCheck& check) {
  CompileOptions options;
  options.allow_out_of_range = command.allow_range;
  const auto compiled = CompileAllWithMap(source, options);
  CheckedFile file{source, compiled.diagnostics()};
  if (compiled && command.lint)
    for (Diagnostic& warning : Lint(*compiled, source))
      file.diagnostics.push_back(std::move(warning));
  check.findings.push_back(std::move(file));
  check.is_fine = static_cast<bool>(compiled);
  if (compiled) check.contents = ContentsOf(*compiled, Escaped(source.name()));
}

void RefuseStore(const Source& source, FileCheck& check) {
  check.findings.push_back(
      {Source(source.name(), ""),
       {Diagnostic(Code::kNotText, {}, "this is the store of a run, no text")
            .WithHelp(fmt::format("look at it with 'plsc show {}'",
                                  source.name()))}});
}

}  // namespace

FileCheck CheckFile(const Source& source, const CheckCommand& command, Io& io) {
  FileCheck check;
  switch (KindOf(source.text())) {
    case FileKind::kGenotype:
      CheckGenotype(source, command, check);
      break;
    case FileKind::kExperiment:
      Take(ReadExperimentText(source, check.findings, io), source, check);
      break;
    case FileKind::kScenario:
      Take(ReadScenarioText(source, check.findings), source, check);
      break;
    case FileKind::kStudy:
      Take(ReadStudyText(source, check.findings, io), source, check);
      break;
    case FileKind::kGolden:
      Take(ParseGolden(source), source, check);
      break;
    case FileKind::kRecording:
      Take(ParseRecording(source), source, check);
      break;
    case FileKind::kDigest:
      Take(ParseDigest(source), source, check);
      break;
    case FileKind::kStore:
      RefuseStore(source, check);
      break;
  }
  return check;
}

}  // namespace plsc::cli
