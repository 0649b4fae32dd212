#include "runtime/report/report.h"
#include "grammar/shown_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ostream>

#include "runtime/cli/arguments/report.h"
#include "runtime/cli/commands/report_files.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/cli/files/output_path.h"
#include "runtime/cli/running/interrupt.h"
#include "runtime/cli/running/lives_line.h"
#include "runtime/cli/running/relive.h"
#include "runtime/cli/running/relive_run.h"
#include "runtime/cli/running/utc_now.h"
#include "runtime/pages/page.h"
#include "runtime/report/claims_text.h"
#include "runtime/report/report_json.h"
#include "runtime/text/version.h"

namespace plsc::cli {

namespace {

Exit WrongUsage(const char* what, Io& io) {
  io.err << fmt::format("plsc: {}\nsee 'plsc report --help'\n", what);
  return Exit::kBadUsage;
}

/// One line that is drawn again; on a terminal only, where somebody waits.
class ReadingLine {
 public:
  ReadingLine(Io& io, bool is_shown)
      : io_(io), is_shown_(is_shown && io.err_is_terminal) {}
  void Report(std::size_t done, std::size_t total) {
    if (!is_shown_ || total < 2) return;
    io_.err << fmt::format("\rreading runs: {}/{}{}", done, total,
                           done == total ? "\n" : "")
            << std::flush;
  }

 private:
  Io& io_;
  bool is_shown_;
};

ReportMade MadeNow() {
  return {fmt::format("plsc {}", kVersion), UtcNow()};
}

/// "4 runs: 3 done, 1 unfinished"
std::string Summary(const StudyReport& report) {
  std::map<RunState, int> states;
  for (const ReportRun& run : report.runs) ++states[run.reading.state];
  std::string text = fmt::format("{} run{}", report.runs.size(),
                                 report.runs.size() == 1 ? "" : "s");
  const char* separator = ": ";
  for (const RunState state :
       {RunState::kDone, RunState::kRunning, RunState::kUnfinished,
        RunState::kMissing, RunState::kDamaged}) {
    const auto found = states.find(state);
    if (found == states.end()) continue;
    text += fmt::format("{}{} {}", separator, found->second,
                        NameIn(kRunStateNames, state));
    separator = ", ";
  }
  return text;
}

/// Runs by whether there is something to show of them.
struct ReportedRuns {
  int readable = 0;
  int damaged = 0;  ///< records of claims, too
};

/// Says what is wrong with runs.
ReportedRuns ReportProblems(const StudyReport& report, Io& io) {
  ReportedRuns reported;
  for (const ReportRun& run : report.runs) {
    if (run.reading.state == RunState::kDamaged) {
      ++reported.damaged;
      io.err << fmt::format("error: {}\n", Escaped(run.reading.problem));
    } else if (run.reading.state != RunState::kMissing) {
      ++reported.readable;
    }
  }
  for (const StudyClaims& study : report.claims) {
    if (study.problem.empty()) continue;
    ++reported.damaged;
    io.err << fmt::format("error: {}\n", Escaped(study.problem));
  }
  return reported;
}

/// The best robots of every run by the engine that it did not have. What
/// cannot be lived by that is said, and left out.
void CheckEngines(int most, StudyReport& report, Io& io) {
  for (ReportRun& run : report.runs) {
    if (run.reading.facts.best == 0) continue;
    const EngineKind other = UsesOde(run.reading.experiment.scenario)
                                 ? EngineKind::kArticulated
                                 : EngineKind::kOde;
    const auto checked = [&]() -> Expected<EngineCheck, Failure> {
      RunStore store;
      if (auto failure = store.OpenForReading(run.input.path)) return *failure;
      auto survivors = SurvivorsOf(store, static_cast<std::size_t>(most));
      if (!survivors) return survivors.error();
      auto check = CheckByEngine(store, survivors->ids, other, std::nullopt);
      if (check) check->generation = survivors->generation;
      return check;
    }();
    if (checked)
      run.check = *checked;
    else
      io.err << fmt::format("warning: no other engine for {}: {}\n",
                            Escaped(run.input.label),
                            Escaped(checked.error().text));
  }
}

/// Survivors of the generation that is compared live again, as often as was
/// asked for. What went wrong with a run is said; false: the user stopped it.
bool ReliveRuns(int lives, bool is_quiet, const StudyReport& report, Io& io) {
  const InterruptHandler handler;
  LivesLine line(io.err, io.err_is_terminal, is_quiet);
  ReliveRequest request;
  request.generations.kind = GenerationChoice::Kind::kList;
  request.generations.list = {report.generation};
  request.lives = lives;
  for (std::size_t i = 0; i < report.runs.size(); ++i) {
    const ReportRun& run = report.runs[i];
    if (run.reading.population.generations <= report.generation) continue;
    const ReliveOutcome outcome = ReliveRun(
        run.input.path, request, std::nullopt,
        [&](std::int64_t done, std::int64_t total) {
          line.Report({i, report.runs.size(), run.input.label, done, total});
        });
    line.Finish();
    if (InterruptHandler::is_interrupted()) {
      io.err << "stopped; what was lived is kept, and the same command goes "
                "on\n";
      return false;
    }
    if (outcome.failure)
      io.err << fmt::format("warning: {}\n", Escaped(outcome.failure->text));
  }
  return true;
}

/// Reads what was lived again, and says what of it is of no use any more.
void TakeRelived(const ReportCommand& command, StudyReport& report, Io& io) {
  const bool has_digests = std::any_of(
      report.runs.begin(), report.runs.end(),
      [](const ReportRun& run) { return run.input.digest != nullptr; });
  if (!has_digests)
    report.relive_command =
        fmt::format("plsc relive {}", fmt::join(command.paths, " "));
  AddRelived(report);
  for (const ReportRun& run : report.runs) {
    if (run.relived.state == RelivedState::kUnusable)
      io.err << fmt::format("warning: {}\n", Escaped(run.relived.problem));
    if (run.relived.state != RelivedState::kOlder) continue;
    io.err << fmt::format(
        "warning: relived lives of {} are of another generation than {}",
        Escaped(run.input.label), report.generation);
    // A digest has no stores to add to.
    if (run.input.digest == nullptr)
      io.err << fmt::format("; plsc relive {} --generations {} adds them",
                            Escaped(run.input.path), report.generation);
    io.err << '\n';
  }
}

Output OutputOf(const ReportCommand& command) {
  const OutputKind kind =
      command.format == ReportFormat::kHtml   ? OutputKind::kPage
      : command.format == ReportFormat::kJson ? OutputKind::kReport
                                              : OutputKind::kClaims;
  return {command.output, kind, command.force, command.paths};
}

std::string TextOf(const ReportCommand& command, const StudyReport& report,
                   const std::vector<ClaimResult>& claims) {
  if (command.format == ReportFormat::kText) return ClaimsText(report, claims);
  const std::string json = ReportJson(report, claims, MadeNow());
  return command.format == ReportFormat::kHtml
             ? PageHtml(PageKind::kReport, report.title, json)
             : json + '\n';
}

Exit Write(const ReportCommand& command, const StudyReport& report, Io& io) {
  const std::vector<ClaimResult> claims = ClaimResultsOf(report);
  if (command.format == ReportFormat::kText && claims.empty())
    return Complain("no whole study that was named claims anything", io);
  const bool is_written =
      command.format == ReportFormat::kFiles
          ? WriteFiles(command, report, claims, io)
          : WriteOutput(OutputOf(command), TextOf(command, report, claims), io);
  if (!is_written) return Exit::kBadInput;
  if (!command.quiet && !command.output.empty() && command.output != "-")
    io.out << fmt::format("{}: {}{}\n", Escaped(command.output),
                          Summary(report),
                          claims.empty() ? "" : "; " + ClaimsSummary(claims));
  return Exit::kFine;
}

}  // namespace

Exit Run(const ReportCommand& command, Io& io) {
  const bool is_page = command.format == ReportFormat::kHtml;
  if (is_page && command.output.empty())
    return WrongUsage("where should the page go? add -o FILE", io);
  const bool is_folder = command.format == ReportFormat::kFiles;
  if (is_folder && (command.output.empty() || command.output == "-"))
    return WrongUsage("where should the files go? add -o FOLDER", io);
  if (!(is_folder ? CanWriteFiles(command, io)
                  : CanWrite(OutputOf(command), io)))
    return Exit::kBadInput;
  const auto measures = ChooseMeasures(command.measures);
  if (!measures) return WrongUsage(measures.error().text.c_str(), io);
  const Expected<ReportInputs, Failure> inputs = FindRuns(command.paths);
  if (!inputs) return Complain(inputs.error(), io);
  if (is_page && !HasPages())
    return Complain(
        "this plsc was built without npm and has no pages; "
        "--format json, text and files work",
        io);
  if ((command.verify || command.relive || command.check_engine) &&
      HasDigests(*inputs))
    return Complain(
        "--verify, --relive and --check-engine look into stores, and runs of a "
        "digest have none; name the study's folder",
        io);
  ReadingLine line(io, !command.quiet);
  StudyReport report = BuildReport(
      *inputs, *measures,
      [&](std::size_t done, std::size_t total) { line.Report(done, total); },
      command.verify);
  const ReportedRuns reported = ReportProblems(report, io);
  if (reported.readable == 0 && reported.damaged == 0)
    return Complain("none of these runs is begun yet", io);
  if (reported.readable == 0) return Exit::kBadInput;
  if (command.check_engine) CheckEngines(*command.check_engine, report, io);
  if (command.relive && report.generation >= 0 &&
      !ReliveRuns(*command.relive, command.quiet, report, io))
    return Exit::kInterrupted;
  TakeRelived(command, report, io);
  const Exit written = Write(command, report, io);
  return written == Exit::kFine && reported.damaged > 0 ? Exit::kBadInput
                                                        : written;
}

}  // namespace plsc::cli
