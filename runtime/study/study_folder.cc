#include "runtime/study/study_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

namespace plsc {

namespace {

using Failure = std::optional<std::string>;
namespace fs = std::filesystem;

constexpr const char* kFile = "study.yaml";
// Of a file that becomes study.yaml as a whole or not at all.
constexpr const char* kPartial = "study.yaml.";

std::string FileIn(const std::string& folder) {
  return (fs::path(folder) / kFile).string();
}

std::string ReasonOf(int error) {
  return std::error_code(error, std::generic_category()).message();
}

Failure WriteWhole(const std::string& path, const std::string& text) {
  const int descriptor =
      open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (descriptor < 0)
    return fmt::format("cannot create '{}': {}", path, ReasonOf(errno));
  std::size_t written = 0;
  int error = 0;
  while (written < text.size() && error == 0) {
    const ssize_t size =
        write(descriptor, text.data() + written, text.size() - written);
    if (size >= 0)
      written += static_cast<std::size_t>(size);
    else if (errno != EINTR)
      error = errno;
  }
  if (error == 0 && fsync(descriptor) != 0) error = errno;
  if (close(descriptor) != 0 && error == 0) error = errno;
  if (error == 0) return std::nullopt;
  unlink(path.c_str());
  return fmt::format("cannot write to '{}': {}", path, ReasonOf(error));
}

/// Of several processes that begin at once, one makes the file and all others
/// find it: a link, unlike a renaming, replaces nothing.
Failure WriteFirst(const std::string& folder, const std::string& text) {
  const std::string path = FileIn(folder);
  const std::string partial =
      (fs::path(folder) / fmt::format("{}{}", kPartial, getpid())).string();
  unlink(partial.c_str());  // of a process of this number that was killed
  if (Failure failure = WriteWhole(partial, text)) return failure;
  const int error = link(partial.c_str(), path.c_str()) == 0 ? 0 : errno;
  unlink(partial.c_str());
  if (error == 0 || error == EEXIST) return std::nullopt;
  return fmt::format("cannot create '{}': {}", path, ReasonOf(error));
}

/// A folder of something else is not ours to fill. What another process makes
/// in it meanwhile comes after study.yaml, so that file is looked for last.
Failure CheckEmpty(const std::string& folder) {
  std::error_code error;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (!entry->path().filename().string().starts_with(kPartial) &&
        !fs::exists(FileIn(folder), ignored))
      return fmt::format("'{}' exists and is no study's folder: it has no {}",
                         folder, kFile);
  if (error)
    return fmt::format("cannot read '{}': {}", folder, error.message());
  return std::nullopt;
}

std::optional<std::string> ReadAll(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) return std::nullopt;
  return text.str();
}

/// "line 5 is 'population: 10' there and 'population: 20' here"
std::string Difference(const std::string& there, const std::string& here) {
  std::istringstream there_lines(there);
  std::istringstream here_lines(here);
  for (int number = 1;; ++number) {
    std::string theirs;
    std::string ours;
    const bool has_theirs = !!std::getline(there_lines, theirs);
    const bool has_ours = !!std::getline(here_lines, ours);
    if (theirs == ours && has_theirs == has_ours) continue;
    const auto shown = [](bool has_line, const std::string& line) {
      const std::size_t begin = line.find_first_not_of(' ');
      return has_line && begin != std::string::npos
                 ? fmt::format("'{}'", line.substr(begin))
                 : "missing";
    };
    return fmt::format("line {} of its {} is {}, and here {}", number, kFile,
                       shown(has_theirs, theirs), shown(has_ours, ours));
  }
}

}  // namespace

Failure PrepareFolder(const std::string& folder, const Study& study) {
  const std::string text = PrintStudy(study);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    return fmt::format("cannot create '{}': {}", folder, error.message());
  if (!fs::exists(FileIn(folder), error)) {
    if (Failure failure = CheckEmpty(folder)) return failure;
    if (Failure failure = WriteFirst(folder, text)) return failure;
  }
  const std::optional<std::string> there = ReadAll(FileIn(folder));
  if (!there) return fmt::format("cannot read '{}'", FileIn(folder));
  if (*there != text)
    return fmt::format("'{}' is the folder of another study: {}", folder,
                       Difference(*there, text));
  for (const StudyExperiment& one : study.experiments) {
    const fs::path path = fs::path(folder) / one.name;
    fs::create_directories(path, error);
    if (error)
      return fmt::format("cannot create '{}': {}", path.string(),
                         error.message());
  }
  return std::nullopt;
}

Loaded<Study> StudyIn(const std::string& folder) {
  const std::string path = FileIn(folder);
  const std::optional<std::string> text = ReadAll(path);
  if (!text)
    return Loaded<Study>::Failed(
        fmt::format("'{}' is no study's folder: it has no {} that can be read",
                    folder, kFile));
  Result<Study> study = ParseStudy(Source(path, *text));
  if (!study)
    return Loaded<Study>::Failed(fmt::format(
        "'{}' is damaged: {}", path, study.diagnostics().front().message));
  return std::move(*study);
}

std::string RunPath(const std::string& folder, const Study& study,
                    const StudyRun& run) {
  return (fs::path(folder) / study.experiments[run.experiment].name /
          fmt::format("{}.sqlite", run.repetition))
      .string();
}

}  // namespace plsc
