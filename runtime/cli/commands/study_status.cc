#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <ostream>

#include "grammar/shown_line.h"
#include "runtime/cli/arguments/study.h"
#include "runtime/study/claims_record.h"
#include "runtime/study/run_report.h"
#include "runtime/study/study_folder.h"
#include "runtime/text/json_dump.h"
#include "runtime/text/quantity.h"

namespace plsc::cli {

namespace {

/// "flat 3.63 tilted 1.32 cm/s"; - for a life that was not completed.
std::string SpeedsText(const RunReport& report) {
  std::string text;
  for (const SeasonSpeed& season : report.best) {
    text += Escaped(season.season) + " ";
    text += season.speed ? fmt::format("{:.2f} ", kCentimetres * *season.speed)
                         : "- ";
  }
  return text.empty() ? "" : text + "cm/s";
}

/// So far of all runs.
struct Totals {
  std::map<RunState, int> states;
  std::int64_t evaluations = 0;  ///< done
  std::int64_t planned = 0;
  std::vector<std::string> problems;
};

void PrintRow(const Study& study, const StudyRun& run, const RunReport& report,
              std::ostream& out) {
  const Experiment& experiment = study.experiments[run.experiment].experiment;
  const std::string line = fmt::format(
      "{:16} {:10} {:>11} {:>13}  {}", Escaped(RunName(study, run)),
      NameIn(kRunStateNames, report.state),
      fmt::format("{}/{}", report.generations, experiment.generations),
      fmt::format("{}/{}", report.evaluations, Evaluations(experiment)),
      SpeedsText(report));
  out << line.substr(0, line.find_last_not_of(' ') + 1) << '\n';
}

void PrintJson(const std::string& folder, const Study& study,
               const StudyRun& run, const RunReport& report,
               std::ostream& out) {
  const Experiment experiment = ExperimentOf(study, run);
  const auto text_or_null = [](const std::string& text) {
    return text.empty() ? nlohmann::ordered_json(nullptr)
                        : nlohmann::ordered_json(text);
  };
  nlohmann::ordered_json json;
  json["experiment"] = study.experiments[run.experiment].name;
  json["repetition"] = run.repetition;
  json["seed"] = std::to_string(experiment.seed);
  json["run"] = RunPath(folder, study, run);
  json["state"] = NameIn(kRunStateNames, report.state);
  json["generations"] = report.generations;
  json["generations_planned"] = experiment.generations;
  json["evaluations"] = report.evaluations;
  json["evaluations_planned"] = Evaluations(experiment);
  json["worker"] = text_or_null(report.worker);
  json["problem"] = text_or_null(report.problem);
  json["best_speed"] = nlohmann::ordered_json::object();  // m/s
  for (const SeasonSpeed& season : report.best)
    json["best_speed"][season.season] =
        season.speed ? nlohmann::ordered_json(*season.speed)
                     : nlohmann::ordered_json(nullptr);
  out << DumpJson(json) << '\n';
}

void PrintTotals(const Totals& totals, std::ostream& out) {
  std::string text;
  int runs = 0;
  for (const RunState state :
       {RunState::kDone, RunState::kRunning, RunState::kUnfinished,
        RunState::kMissing, RunState::kDamaged}) {
    const auto count = totals.states.find(state);
    if (count == totals.states.end()) continue;
    text +=
        fmt::format(", {} {}", count->second, NameIn(kRunStateNames, state));
    runs += count->second;
  }
  out << fmt::format("{} run{}{}; {} of {} evaluations ({:.0f} %)\n", runs,
                     runs == 1 ? "" : "s", text, totals.evaluations,
                     totals.planned,
                     100 * static_cast<double>(totals.evaluations) /
                         static_cast<double>(totals.planned));
}

/// "12 claims, stated 2026-11-30T12:00:00Z before the first run", and a line
/// for every change afterwards.
void PrintStated(const ClaimsRecord& record, std::ostream& out) {
  for (const ClaimsVersion& version : record)
    out << fmt::format("{}{} claim{}, {} {} {}\n",
                       &version == &record.front() ? "" : "changed to ",
                       version.claims.size(),
                       version.claims.size() == 1 ? "" : "s",
                       &version == &record.front() ? "stated" : "at",
                       Escaped(version.stated), WhenStated(version));
}

}  // namespace

Exit Run(const StudyStatusCommand& command, Io& io) {
  const Expected<Study, Failure> study = StudyIn(command.folder);
  if (!study) {
    io.err << fmt::format("error: {}\n", Escaped(study.error().text));
    return Exit::kBadInput;
  }
  const bool is_text = command.format == OutputFormat::kText;
  if (is_text)
    io.out << fmt::format("{:16} {:10} {:>11} {:>13}  {}\n", "run", "state",
                          "generations", "evaluations", "best robot");
  Totals totals;
  for (const StudyRun& run : RunsOf(*study)) {
    const RunReport report = ReportOn(command.folder, *study, run);
    if (is_text)
      PrintRow(*study, run, report, io.out);
    else
      PrintJson(command.folder, *study, run, report, io.out);
    ++totals.states[report.state];
    totals.evaluations += report.evaluations;
    totals.planned +=
        Evaluations(study->experiments[run.experiment].experiment);
    if (!report.problem.empty()) totals.problems.push_back(report.problem);
  }
  if (is_text) PrintTotals(totals, io.out);
  const Expected<ClaimsRecord, Failure> record = ClaimsIn(command.folder);
  if (!record)
    totals.problems.push_back(record.error().text);
  else if (is_text)
    PrintStated(*record, io.out);
  for (const std::string& problem : totals.problems)
    io.err << fmt::format("error: {}\n", Escaped(problem));
  return totals.problems.empty() ? Exit::kFine : Exit::kBadInput;
}

}  // namespace plsc::cli
