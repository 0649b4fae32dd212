#include "runtime/report/inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "runtime/relive/relived_file.h"
#include "runtime/study/study_folder.h"

namespace plsc {

namespace {

namespace fs = std::filesystem;
using Inputs = Expected<ReportInputs, Failure>;

constexpr const char* kStudyFile = "study.yaml";

/// Without a '/' at its end, so that it has a name.
fs::path Cleaned(const std::string& path) {
  const fs::path clean = fs::path(path).lexically_normal();
  return clean.has_filename() ? clean : clean.parent_path();
}

/// The path that a run has however it is written.
std::string Canonical(const std::string& path) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(path, error);
  return error ? path : canonical.string();
}

std::string NameOf(const fs::path& folder) {
  return Cleaned(Canonical(folder.string())).filename().string();
}

/// The runs of a study, or of one of its experiments.
Inputs RunsOfStudy(const std::string& folder, const std::string& only) {
  const Expected<Study, Failure> study = StudyIn(folder);
  if (!study) return study.error();
  ReportInputs inputs;
  inputs.title = study->name.empty() ? NameOf(folder) : study->name;
  for (const StudyRun& run : RunsOf(*study)) {
    const std::string& experiment = study->experiments[run.experiment].name;
    if (!only.empty() && experiment != only) continue;
    inputs.runs.push_back({RunPath(folder, *study, run), RunName(*study, run),
                           experiment, ExperimentOf(*study, run)});
  }
  return inputs;
}

Inputs RunsInFolder(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> paths;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().extension() == ".sqlite" &&
        !IsRelivedFile(entry->path().string()))
      paths.push_back(entry->path().string());
  if (error)
    return Failure(
        fmt::format("cannot read '{}': {}", folder, error.message()));
  if (paths.empty())
    return Failure(fmt::format(
        "'{}' is no study's folder and has no runs (*.sqlite)", folder));
  std::sort(paths.begin(), paths.end());
  ReportInputs inputs;
  inputs.title = NameOf(folder);
  for (const std::string& path : paths)
    inputs.runs.push_back({path, fs::path(path).filename().string(), "", {}});
  return inputs;
}

bool HasStudy(const fs::path& folder) {
  std::error_code error;
  return fs::exists(folder / kStudyFile, error);
}

/// A study's own run keeps its place in the study.
Inputs RunOfFile(const std::string& path) {
  const fs::path folder = fs::path(Canonical(path)).parent_path();
  if (HasStudy(folder.parent_path())) {
    const Inputs all =
        RunsOfStudy(folder.parent_path().string(), folder.filename().string());
    if (all)
      for (const ReportInput& run : all->runs)
        if (Canonical(run.path) == Canonical(path)) {
          ReportInput same = run;
          same.path = path;
          return ReportInputs{run.label, {std::move(same)}};
        }
  }
  const std::string name = fs::path(path).filename().string();
  return ReportInputs{name, {{path, name, "", {}}}};
}

Inputs RunsAt(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error))
    return Failure(
        fmt::format("cannot read '{}': no such file or folder", path));
  if (!fs::is_directory(path, error)) {
    const std::string extension = fs::path(path).extension().string();
    if (extension == ".yaml" || extension == ".yml")
      return Failure(fmt::format(
          "'{}' is no run; name the folder that 'plsc study run' filled",
          path));
    return RunOfFile(path);
  }
  const fs::path folder = Cleaned(path);
  if (HasStudy(folder)) return RunsOfStudy(folder.string(), "");
  const fs::path whole = Canonical(folder.string());
  if (HasStudy(whole.parent_path())) {
    Inputs part =
        RunsOfStudy(whole.parent_path().string(), whole.filename().string());
    if (!part || !part->runs.empty()) return part;
  }
  return RunsInFolder(folder.string());
}

}  // namespace

Inputs FindRuns(const std::vector<std::string>& paths) {
  ReportInputs all;
  std::vector<std::string> seen;
  for (const std::string& path : paths) {
    // Beside runs as a shell names them: *.sqlite.
    if (IsRelivedFile(path) && paths.size() > 1) continue;
    Inputs found = RunsAt(path);
    if (!found) return found;
    all.title += (all.title.empty() ? "" : ", ") + found->title;
    for (ReportInput& run : found->runs) {
      std::string canonical = Canonical(run.path);
      if (std::find(seen.begin(), seen.end(), canonical) != seen.end())
        continue;
      seen.push_back(std::move(canonical));
      all.runs.push_back(std::move(run));
    }
  }
  if (all.runs.empty())
    return Failure("all of these are of relived lives; name their runs");
  return all;
}

}  // namespace plsc
