// One rule for what an output may replace (docs/formats.md), asked twice:
// before the work, so that nobody waits an hour to be told, and again when it
// is written, as much may have happened since. A file is replaced if plsc made
// one of this kind before, which its beginning or end shows (output_mark);
// never what the command itself reads, under whatever name, and never a
// database.

#include "runtime/cli/files/output_path.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <ostream>

#include "grammar/shown_line.h"
#include "runtime/cli/files/load_program.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/cli/files/output_file.h"

namespace plsc::cli {

namespace {

namespace fs = std::filesystem;

bool IsMarked(const std::string& path, OutputKind kind) {
  std::ifstream file(path, std::ios::binary);
  std::string beginning(kMarkBytes, '\0');
  file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(file.gcount()));
  file.clear();
  std::error_code error;
  const auto size = fs::file_size(path, error);
  if (error) return false;
  const auto tail = std::min<std::uintmax_t>(size, kMarkBytes);
  std::string end(static_cast<std::size_t>(tail), '\0');
  file.seekg(static_cast<std::streamoff>(size - tail));
  file.read(end.data(), static_cast<std::streamsize>(end.size()));
  end.resize(static_cast<std::size_t>(file.gcount()));
  return HasMark(kind, beginning, end);
}

// Why a new file cannot be made there; errors of the system are told when it
// is opened.
std::optional<std::string> ProblemOfFolder(const std::string& path) {
  std::error_code error;
  fs::path folder = fs::path(path).parent_path();
  if (folder.empty()) folder = ".";
  if (!fs::is_directory(folder, error)) return "its folder does not exist";
  if (::access(folder.c_str(), W_OK) != 0)
    return "its folder cannot be written to";
  return std::nullopt;
}

// Of a file that is there.
std::optional<std::string> ProblemOfFile(const Output& output) {
  const std::string& path = output.path;
  std::error_code error;
  if (std::any_of(output.inputs.begin(), output.inputs.end(),
                  [&](const std::string& input) {
                    return fs::equivalent(path, SplitGenotypePath(input).file,
                                          error);
                  }))
    return "the command reads it; choose another name";
  if (IsDatabase(path))
    return "it is a database, as stores of runs are; choose another name";
  if (output.force || fs::file_size(path, error) == 0) return std::nullopt;
  if (!IsReplaced(output.kind)) return "it exists; --force replaces it";
  if (!IsMarked(path, output.kind))
    return fmt::format("it is no {} that plsc made; --force replaces it",
                       KindName(output.kind));
  return std::nullopt;
}

std::optional<std::string> ProblemOf(const Output& output) {
  const std::string& path = output.path;
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    std::error_code error;
    if (fs::is_symlink(path, error))
      return "it is a symbolic link that leads nowhere";
    return ProblemOfFolder(path);
  }
  if (S_ISDIR(status.st_mode)) return "it is a folder";
  if (S_ISREG(status.st_mode)) return ProblemOfFile(output);
  if (S_ISFIFO(status.st_mode) || S_ISCHR(status.st_mode)) return std::nullopt;
  return "it is neither a file nor a pipe";
}

}  // namespace

bool CanWrite(const Output& output, Io& io) {
  const std::string& path = output.path;
  if (path.empty() || path == "-" || IsDescriptor(path)) return true;
  const auto problem = ProblemOf(output);
  if (problem)
    io.err << fmt::format("error: cannot write '{}': {}\n", Escaped(path),
                          Escaped(*problem));
  return !problem;
}

bool MakeFolder(const std::string& folder, Io& io) {
  std::error_code error;
  fs::create_directories(folder, error);
  // A link to a folder is no error, nor is "folder/".
  std::error_code ignored;
  if (!error || fs::is_directory(folder, ignored)) return true;
  io.err << fmt::format("error: cannot make the folder '{}': {}\n",
                        Escaped(folder), error.message());
  return false;
}

bool WriteOutput(const Output& output, std::string_view text, Io& io) {
  const std::string& path = output.path;
  if (path.empty() || path == "-" || path == "/dev/stdout") {
    io.out << text;
    return true;
  }
  // Much may have happened since it was asked first.
  return CanWrite(output, io) && WriteOrReport(path, text, io);
}

}  // namespace plsc::cli
