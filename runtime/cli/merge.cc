#include <fmt/format.h>

#include <array>
#include <ostream>
#include <utility>

#include "compiler/compile.h"
#include "compiler/merge_program.h"
#include "runtime/cli/commands.h"
#include "runtime/cli/output_path.h"

namespace plsc::cli {

namespace {

bool IsBlank(const Source& source) {
  return source.text().find_first_not_of(" \t\r\n") == std::string_view::npos;
}

// A version that can be merged; prints why there is none. An empty base is
// what git has for a file that both sides added.
std::optional<Source> ReadVersion(const std::string& path, bool may_be_empty,
                                  const MergeCommand& command, Io& io) {
  Result<Source> source = ReadSource(path, io);
  if (!source) {
    const Diagnostic& problem = source.diagnostics()[0];
    io.err << fmt::format("error[{}]: {}\n", problem.code, problem.message);
    return std::nullopt;
  }
  if (may_be_empty && IsBlank(*source)) return std::move(*source);
  CompileOptions options;
  options.allow_out_of_range = command.allow_range;
  const auto compiled = CompileAll(*source, options);
  if (compiled) return std::move(*source);
  Report(compiled.diagnostics(), *source, io);
  return std::nullopt;
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
  CompileOptions options;
  options.allow_out_of_range = command.allow_range;
  const auto compiled = CompileAll(merged, options);
  if (compiled) return true;
  Report(compiled.diagnostics(), merged, io);
  io.err << fmt::format(
      "{}: merged without conflict, but what both sides made together is "
      "wrong\n",
      NameOf(command));
  return false;
}

// Whether it is written.
bool WriteMerge(const std::string& text, const MergeCommand& command, Io& io) {
  const std::string& path =
      command.is_driver || command.write_ours ? command.ours : command.output;
  if (path.empty()) {
    io.out << text;
    return true;
  }
  const auto failure = WriteFile(path, text);
  if (failure)
    io.err << fmt::format("error: cannot write '{}': {}\n", path, *failure);
  return !failure;
}

}  // namespace

Exit Run(const MergeCommand& command, Io& io) {
  if (!CanWrite(command.output, {command.base, command.ours, command.theirs},
                io))
    return Exit::kTrouble;
  const auto base = ReadVersion(command.base, true, command, io);
  const auto ours = ReadVersion(command.ours, false, command, io);
  const auto theirs = ReadVersion(command.theirs, false, command, io);
  if (!base || !ours || !theirs) {
    io.err << fmt::format("{}: not merged, and left as it was\n",
                          NameOf(command));
    return Exit::kTrouble;
  }
  const MergedFile merged =
      MergeFiles(*base, *ours, *theirs, LabelsOf(command));
  for (const MergeConflict& conflict : merged.conflicts)
    io.err << fmt::format("{}:{}: conflict: {}\n", NameOf(command),
                          conflict.line, conflict.message);
  const bool is_fine =
      merged.conflicts.empty() && IsCorrect(merged.text, command, io);
  if (!WriteMerge(merged.text, command, io)) return Exit::kTrouble;
  return is_fine ? Exit::kFine : Exit::kDiffers;
}

}  // namespace plsc::cli
