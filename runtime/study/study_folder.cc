// The folder says by its study.yaml which study it is of, with every value
// written out, and is refused to any other: results of two studies in one
// folder would be compared as if they were one. What is claimed of its runs
// makes no other study. Of several processes that begin
// at once one makes that file (store/new_file) and the others find it.

#include "runtime/study/study_folder.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "runtime/store/new_file.h"

namespace plsc {

namespace {
namespace fs = std::filesystem;

constexpr const char* kFile = "study.yaml";
// Of what becomes study.yaml when it is whole, maybe by another process.
constexpr const char* kPartial = "study.yaml.";

std::string FileIn(const std::string& folder) {
  return (fs::path(folder) / kFile).string();
}

/// All that its runs are a function of.
std::string TextOf(const Study& study) {
  Study runs = study;
  runs.claims.clear();
  return PrintStudy(runs);
}

/// Folders that go away again with the object if there is nothing in them.
class MadeFolders {
 public:
  MadeFolders() = default;
  ~MadeFolders() {
    std::error_code ignored;
    for (auto made = made_.rbegin(); made != made_.rend(); ++made)
      fs::remove(*made, ignored);
  }
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;

  MaybeFailure Make(const fs::path& folder) {
    std::error_code error;
    const fs::path parent = folder.parent_path();
    if (!parent.empty() && !fs::exists(parent, error))
      if (MaybeFailure failure = Make(parent)) return failure;
    if (fs::create_directory(folder, error)) made_.push_back(folder);
    if (!error || fs::is_directory(folder, error)) return std::nullopt;
    return fmt::format("cannot create '{}': {}", folder.string(),
                       error.message());
  }
  void Keep() { made_.clear(); }

 private:
  std::vector<fs::path> made_;
};

/// Of several processes that begin at once, one makes the file and all others
/// find it.
MaybeFailure WriteFirst(const std::string& folder, const std::string& text) {
  NewFile file(FileIn(folder));
  MaybeFailure failure = file.Write(text);
  if (!failure) failure = file.Publish();
  std::error_code error;
  if (failure && fs::exists(FileIn(folder), error)) return std::nullopt;
  return failure;
}

/// A folder of something else is not ours to fill. What another process makes
/// in it meanwhile comes after study.yaml, so that file is looked for last.
MaybeFailure CheckEmpty(const std::string& folder) {
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

MaybeFailure PrepareFolder(const std::string& folder, const Study& study) {
  MadeFolders made;
  if (MaybeFailure failure = made.Make(folder)) return failure;
  const std::string text = TextOf(study);
  std::error_code error;
  if (!fs::exists(FileIn(folder), error)) {
    if (MaybeFailure failure = CheckEmpty(folder)) return failure;
    if (MaybeFailure failure = WriteFirst(folder, text)) return failure;
  }
  if (MaybeFailure failure = CheckFolder(folder, study)) return failure;
  for (const StudyExperiment& one : study.experiments)
    if (MaybeFailure failure = made.Make(fs::path(folder) / one.name))
      return failure;
  made.Keep();
  return std::nullopt;
}

MaybeFailure CheckFolder(const std::string& folder, const Study& study) {
  const std::string text = TextOf(study);
  const std::optional<std::string> there = ReadAll(FileIn(folder));
  if (!there) return fmt::format("cannot read '{}'", FileIn(folder));
  if (*there == text) return std::nullopt;
  return fmt::format("'{}' is the folder of another study: {}", folder,
                     Difference(*there, text));
}

Expected<Study, Failure> StudyIn(const std::string& folder) {
  const std::string path = FileIn(folder);
  const std::optional<std::string> text = ReadAll(path);
  if (!text)
    return Failure(
        fmt::format("'{}' is no study's folder: it has no {} that can be read",
                    folder, kFile));
  Result<Study> study = ParseStudy(Source(path, *text));
  if (!study)
    return Failure(fmt::format("'{}' is damaged: {}", path,
                               study.diagnostics().front().message));
  return std::move(*study);
}

std::string RunPath(const std::string& folder, const Study& study,
                    const StudyRun& run) {
  return (fs::path(folder) / study.experiments[run.experiment].name /
          fmt::format("{}.sqlite", run.repetition))
      .string();
}

}  // namespace plsc
