#include "runtime/store/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <ostream>
#include <system_error>
#include <utility>

#include "runtime/cli/arguments/command.h"
#include "runtime/cli/commands/export_robot.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/cli/files/output_path.h"
#include "runtime/cli/files/pipe_errors.h"

namespace plsc::cli {

namespace {

std::string SystemReason(int error) {
  return std::error_code(error, std::generic_category()).message();
}

/// A file that takes its name when it is written to its end; a pipe or a device
/// is written into. Of the C library, whose functions say why they failed.
class NewFile {
 public:
  explicit NewFile(const std::string& path)
      : path_(RealPath(path)),
        beside_(IsWrittenInto(path_) ? "" : NeighbourOf(path_)),
        // Exclusive: what has the neighbour's name is not ours.
        file_(beside_.empty() ? std::fopen(path_.c_str(), "abe")
                              : std::fopen(beside_.c_str(), "wbxe")),
        error_(file_ != nullptr ? 0 : errno),
        is_made_(file_ != nullptr && !beside_.empty()) {}
  ~NewFile() {
    if (file_ != nullptr) std::fclose(file_);
    std::error_code ignored;
    if (is_made_ && !is_done_) std::filesystem::remove(beside_, ignored);
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  MaybeFailure Write(std::string_view text) {
    if (error_ == 0 &&
        std::fwrite(text.data(), 1, text.size(), file_) != text.size())
      error_ = errno;
    return Check();
  }
  MaybeFailure Finish() {
    // Closing writes what is buffered, and may fail as writing does.
    if (error_ == 0 && std::fclose(std::exchange(file_, nullptr)) != 0)
      error_ = errno;
    if (error_ == 0 && is_made_ &&
        std::rename(beside_.c_str(), path_.c_str()) != 0)
      error_ = errno;
    is_done_ = error_ == 0;
    return Check();
  }

 private:
  MaybeFailure Check() const {
    if (error_ == 0) return std::nullopt;
    return fmt::format("cannot write to '{}': {}", path_, SystemReason(error_));
  }

  PipeErrors are_errors_;
  std::string path_;
  std::string beside_;
  std::FILE* file_;
  int error_;
  bool is_made_;  // the neighbour
  bool is_done_ = false;
};

/// What could be read of a damaged run is a file, too.
template <typename Writer>
MaybeFailure WriteFileWith(const std::string& path, const Writer& write) {
  NewFile file(path);
  bool is_written = true;
  MaybeFailure failure = write([&](std::string_view text) {
    MaybeFailure wrong = file.Write(text);
    is_written = is_written && !wrong;
    return wrong;
  });
  if (!is_written) return failure;
  MaybeFailure unfinished = file.Finish();
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
