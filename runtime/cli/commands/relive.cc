#include "runtime/cli/arguments/relive.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>
#include <system_error>

#include "grammar/shown_line.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/cli/running/interrupt.h"
#include "runtime/cli/running/lives_line.h"
#include "runtime/cli/running/relive_run.h"
#include "runtime/report/inputs.h"
#include "runtime/text/json_dump.h"

namespace plsc::cli {

namespace {

constexpr int kReliveFormat = 1;

/// Runs of a study that are not begun yet are no mistake.
std::vector<ReportInput> BegunRuns(const ReportInputs& inputs) {
  std::vector<ReportInput> begun;
  std::error_code error;
  for (const ReportInput& run : inputs.runs)
    if (std::filesystem::exists(run.path, error)) begun.push_back(run);
  return begun;
}

/// As the user would type it again.
std::string CommandText(const ReliveCommand& command) {
  std::string text =
      fmt::format("plsc relive {}", fmt::join(command.paths, " "));
  const ReliveCommand usual;
  if (command.generations != usual.generations)
    text += fmt::format(" --generations '{}'", command.generations);
  if (command.lives != usual.lives)
    text += fmt::format(" --lives {}", command.lives);
  if (command.swaps != usual.swaps)
    text += fmt::format(" --swap {}", command.swaps);
  if (command.engine_check) text += " --engine-check";
  if (command.jobs) text += fmt::format(" --jobs {}", *command.jobs);
  return Escaped(text);
}

/// What there is to be said of a run besides its numbers.
void Mention(const ReportInput& run, const ReliveOutcome& outcome, Io& io) {
  if (!outcome.note.empty())
    io.err << fmt::format("note: {}\n", Escaped(outcome.note));
  if (outcome.failure)
    io.err << fmt::format("error: {}\n", Escaped(outcome.failure->text));
  if (outcome.deaths > 0)
    io.err << fmt::format(
        "warning: {} of {}: the processes that lived them died; the same "
        "command lives them again\n",
        outcome.deaths == 1 ? "a life"
                            : fmt::format("{} lives", outcome.deaths),
        Escaped(run.label));
}

void Stopped(const ReliveCommand& command, const ReportInput& run,
             const ReliveOutcome& outcome, Io& io) {
  io.err << fmt::format(
      "stopped after {} of {} lives of {}, which are in {}; go on with\n  {}\n",
      outcome.lived, outcome.missing, Escaped(run.label),
      Escaped(RelivedPathOf(run.path)), CommandText(command));
}

}  // namespace

Exit Run(const ReliveCommand& command, Io& io) {
  ReliveRequest request;
  const auto generations = ParseGenerations(command.generations);
  if (!generations) {
    io.err << fmt::format("plsc: --generations: {}\nsee 'plsc relive --help'\n",
                          Escaped(generations.error().text));
    return Exit::kBadUsage;
  }
  request.generations = *generations;
  request.lives = command.lives;
  request.swaps = command.swaps;
  request.is_engine_checked = command.engine_check;
  const Expected<ReportInputs, Failure> inputs = FindRuns(command.paths);
  if (!inputs) return Complain(inputs.error(), io);
  if (HasDigests(*inputs))
    return Complain(
        "runs of a digest have no stores, whose robots could live again; name "
        "the study's folder",
        io);
  const std::vector<ReportInput> runs = BegunRuns(*inputs);
  if (runs.empty()) return Complain("none of these runs is begun yet", io);
  const InterruptHandler handler;
  LivesLine line(io.err, io.err_is_terminal, command.quiet);
  Exit exit = Exit::kFine;
  nlohmann::ordered_json json{{"plsc_relived", kReliveFormat}};
  json["runs"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const ReliveOutcome outcome =
        ReliveRun(runs[i].path, request, command.jobs,
                  [&](std::int64_t done, std::int64_t total) {
                    line.Report({i, runs.size(), runs[i].label, done, total});
                  });
    line.Finish();
    Mention(runs[i], outcome, io);
    if (outcome.exit == Exit::kInterrupted ||
        InterruptHandler::is_interrupted()) {
      Stopped(command, runs[i], outcome, io);
      return Exit::kInterrupted;
    }
    if (outcome.exit != Exit::kFine) exit = outcome.exit;
    if (!outcome.result) continue;
    if (command.format == OutputFormat::kJson)
      json["runs"].push_back(RelivedJson(*outcome.result));
    else
      io.out << RelivedText(*outcome.result) << std::flush;
  }
  if (command.format == OutputFormat::kJson) io.out << DumpJson(json) << '\n';
  return exit;
}

}  // namespace plsc::cli
