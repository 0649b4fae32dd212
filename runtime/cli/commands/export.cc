#include "runtime/store/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <utility>

#include "runtime/cli/arguments/exports.h"
#include "runtime/cli/commands/export_robot.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/cli/files/output_file.h"
#include "runtime/cli/files/output_path.h"

namespace plsc::cli {

namespace {

/// What could be read of a damaged run is a file, too.
template <typename Writer>
MaybeFailure WriteFileWith(const std::string& path, const Writer& write) {
  OutputFile file(path);
  const auto told =
      [&](const std::optional<std::string>& reason) -> MaybeFailure {
    if (!reason) return std::nullopt;
    return fmt::format("cannot write to '{}': {}", file.path(), *reason);
  };
  bool is_written = true;
  MaybeFailure failure = write([&](std::string_view text) {
    MaybeFailure wrong = told(file.Write(text));
    is_written = is_written && !wrong;
    return wrong;
  });
  if (!is_written) return failure;
  MaybeFailure unfinished = told(file.Finish());
  return failure ? failure : unfinished;
}

Output TableOf(const ExportCommand& command, const CsvTable& table) {
  const std::filesystem::path folder = command.csv_folder;
  return {(folder / (table.name + ".csv")).string(),
          OutputKind::kTable,
          command.force,
          {command.file}};
}

bool CanWriteAll(const ExportCommand& command, Io& io) {
  if (command.jsonl)
    return CanWrite(
        {command.output, OutputKind::kRunLines, command.force, {command.file}},
        io);
  return MakeFolder(command.csv_folder, io) &&
         std::all_of(CsvTables().begin(), CsvTables().end(),
                     [&](const CsvTable& table) {
                       return CanWrite(TableOf(command, table), io);
                     });
}

MaybeFailure ExportTables(const ExportCommand& command) {
  CsvExport run;
  if (MaybeFailure failure = run.Open(command.file)) return failure;
  MaybeFailure first = run.damage();
  for (const CsvTable& table : CsvTables()) {
    const std::string path = TableOf(command, table).path;
    MaybeFailure failure = WriteFileWith(
        path, [&](const Sink& sink) { return run.Write(table, sink); });
    if (failure && !first) first = std::move(failure);
  }
  return first;
}

MaybeFailure ExportLines(const ExportCommand& command, Io& io) {
  if (command.output.empty() || command.output == "-")
    return WriteJsonl(command.file, [&](std::string_view text) -> MaybeFailure {
      io.out << text;
      if (io.out) return std::nullopt;
      return "cannot write to standard output";
    });
  return WriteFileWith(command.output, [&](const Sink& sink) {
    return WriteJsonl(command.file, sink);
  });
}

}  // namespace

Exit Run(const ExportCommand& command, Io& io) {
  if (command.to) return ExportRobots(command, io);
  if (command.csv_folder.empty() && !command.jsonl) {
    io.err << "plsc: export as what? add --to FORMAT for a robot; --csv FOLDER "
              "or --jsonl for a run\n"
              "see 'plsc export --help'\n";
    return Exit::kBadUsage;
  }
  {
    // Nothing is written for what is no run.
    RunStore store;
    if (const MaybeFailure failure = store.OpenForReading(command.file))
      return Complain(*failure, io);
  }
  if (!CanWriteAll(command, io)) return Exit::kBadInput;
  const MaybeFailure failure =
      command.jsonl ? ExportLines(command, io) : ExportTables(command);
  return failure ? Complain(*failure, io) : Exit::kFine;
}

}  // namespace plsc::cli
