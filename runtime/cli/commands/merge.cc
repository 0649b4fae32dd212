#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <utility>

#include "compiler/changes/merge_lines.h"
#include "compiler/changes/merge_program.h"
#include "compiler/compile.h"
#include "runtime/cli/arguments/git.h"
#include "runtime/cli/files/output_file.h"
#include "runtime/cli/files/output_path.h"

namespace plsc::cli {

namespace {

bool IsBlank(const Source& source) {
  return source.text().find_first_not_of(" \t\r\n") == std::string_view::npos;
}

// One of the three, and why it is no genotype, if it is none.
struct MergedVersion {
  Source source;
  std::vector<Diagnostic> problems;
};

// Compiles. An empty base is what git has for a file that both sides added.
std::vector<Diagnostic> ProblemsOf(const Source& source,
                                   const MergeCommand& command) {
  CompileOptions options;
  options.allow_out_of_range = command.allow_range;
  const auto compiled = CompileAll(source, options);
  if (compiled) return {};
  return compiled.diagnostics();
}

// Prints why it cannot be read. git's temporary files have names that tell
// nobody anything: its driver calls the version "robots/a.pls (theirs)".
std::optional<MergedVersion> ReadVersion(const std::string& path,
                                         const std::string& label,
                                         const MergeCommand& command, Io& io) {
  std::optional<Source> read = ReadOrReport(path, io);
  if (!read) return std::nullopt;
  Source source = command.is_driver && !command.path.empty()
                      ? Source(fmt::format("{} ({})", command.path, label),
                               std::string(read->text()))
                      : std::move(*read);
  const bool is_nothing = path == command.base && IsBlank(source);
  std::vector<Diagnostic> problems;
  if (!is_nothing) problems = ProblemsOf(source, command);
  return MergedVersion{std::move(source), std::move(problems)};
}

MergeLabels LabelsOf(const MergeCommand& command) {
  MergeLabels labels;
  labels.marker_size = command.marker_size;
  const std::array<std::string*, 3> places{&labels.ours, &labels.base,
                                           &labels.theirs};
  for (std::size_t i = 0; i < std::min(places.size(), command.labels.size());
       ++i)
    *places[i] = command.labels[i];
  return labels;
}

std::string NameOf(const MergeCommand& command) {
  if (!command.path.empty()) return command.path;
  return command.output.empty() ? command.ours : command.output;
}

// Whether the merge is a correct genotype; prints why not. A merge without
// conflicts may be wrong: one side uses what the other removed.
bool IsCorrect(const std::string& text, const MergeCommand& command, Io& io) {
  const Source merged(NameOf(command), text);
  const std::vector<Diagnostic> problems = ProblemsOf(merged, command);
  if (problems.empty()) return true;
  Report(problems, merged, io);
  io.err << fmt::format(
      "{}: merged without conflict, but what both sides made together is "
      "wrong\n",
      NameOf(command));
  return false;
}

Output OutputOf(const MergeCommand& command) {
  return {command.output,
          OutputKind::kGenotype,
          command.force,
          {command.base, command.ours, command.theirs}};
}

// Whether it is written.
bool WriteMerge(const std::string& text, const MergeCommand& command, Io& io) {
  if (!command.is_driver && !command.write_ours)
    return WriteOutput(OutputOf(command), text, io);
  return WriteOrReport(command.ours, text, io);
}

Exit NotMerged(const MergeCommand& command, Io& io) {
  io.err << fmt::format("{}: not merged, and left as it was\n",
                        NameOf(command));
  return Exit::kTrouble;
}

// One error a version is enough: this is said amidst git's own words.
void ReportFirst(const std::vector<const MergedVersion*>& versions, Io& io) {
  for (const MergedVersion* version : versions) {
    const auto& problems = version->problems;
    const auto error = std::find_if(
        problems.begin(), problems.end(), [](const Diagnostic& problem) {
          return problem.severity == Severity::kError;
        });
    if (error != problems.end()) Report({*error}, version->source, io);
  }
}

// Neither git nor diff3 have lines in such a text.
bool IsBinary(const MergedVersion& version) {
  return version.source.text().find('\0') != std::string_view::npos;
}

Exit Finish(const MergedFile& merged, bool must_be_correct,
            const MergeCommand& command, Io& io) {
  for (const MergeConflict& conflict : merged.conflicts)
    io.err << fmt::format("{}:{}: conflict: {}\n", NameOf(command),
                          conflict.line, conflict.message);
  const bool is_fine =
      merged.conflicts.empty() &&
      (!must_be_correct || IsCorrect(merged.text, command, io));
  if (!WriteMerge(merged.text, command, io)) return Exit::kTrouble;
  return is_fine ? Exit::kFine : Exit::kDiffers;
}

}  // namespace

Exit Run(const MergeCommand& command, Io& io) {
  if (!CanWrite(OutputOf(command), io)) return Exit::kTrouble;
  const MergeLabels labels = LabelsOf(command);
  const auto base = ReadVersion(command.base, labels.base, command, io);
  const auto ours = ReadVersion(command.ours, labels.ours, command, io);
  const auto theirs = ReadVersion(command.theirs, labels.theirs, command, io);
  if (!base || !ours || !theirs) return NotMerged(command, io);
  const bool are_sides_correct =
      ours->problems.empty() && theirs->problems.empty();
  if (are_sides_correct && base->problems.empty())
    return Finish(
        MergeFiles(base->source, ours->source, theirs->source, labels), true,
        command, io);
  if (!command.is_driver) {
    for (const MergedVersion* version : {&*base, &*ours, &*theirs})
      Report(version->problems, version->source, io);
    return NotMerged(command, io);
  }
  ReportFirst({&*base, &*ours, &*theirs}, io);
  if (IsBinary(*base) || IsBinary(*ours) || IsBinary(*theirs))
    return NotMerged(command, io);
  io.err << fmt::format(
      "{}: a version is no correct genotype, so lines are merged\n",
      NameOf(command));
  return Finish(MergeLines(base->source.text(), ours->source.text(),
                           theirs->source.text(), labels),
                are_sides_correct, command, io);
}

}  // namespace plsc::cli
