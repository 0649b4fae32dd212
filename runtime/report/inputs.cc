#include "runtime/report/inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
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

StudyClaims ClaimsOf(const std::string& title,
                     Expected<ClaimsRecord, Failure> record) {
  if (!record) return {title, {}, record.error().text};
  return {title, std::move(*record), ""};
}

/// The runs of a study, or of one of its experiments.
Inputs RunsOfStudy(const std::string& folder, const std::string& only) {
  const Expected<Study, Failure> study = StudyIn(folder);
  if (!study) return study.error();
  ReportInputs inputs;
  inputs.title = study->name.empty() ? NameOf(folder) : study->name;
  if (only.empty())
    inputs.claims.push_back(ClaimsOf(inputs.title, ClaimsIn(folder)));
  for (const StudyRun& run : RunsOf(*study)) {
    const std::string& experiment = study->experiments[run.experiment].name;
    if (!only.empty() && experiment != only) continue;
    inputs.runs.push_back({RunPath(folder, *study, run), RunName(*study, run),
                           experiment, ExperimentOf(*study, run)});
    if (only.empty()) inputs.runs.back().study = 0;
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

/// "paper.json:7:13: expected a number for 'cpu_seconds', found null"
std::string FirstErrorOf(const std::vector<Diagnostic>& errors,
                         const Source& source) {
  const Position place = source.PositionOf(errors.front().span.begin);
  return fmt::format("{}:{}:{}: {}", source.name(), place.line, place.column,
                     errors.front().message);
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

/// The text of a digest; nothing if the file is something else.
std::optional<std::string> DigestText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string begin(kDigestMark.size(), '\0');
  if (!file.read(begin.data(), static_cast<std::streamsize>(begin.size())) ||
      begin != kDigestMark)
    return std::nullopt;
  return begin + std::string(std::istreambuf_iterator<char>(file), {});
}

/// All runs of its study: those that it lacks are missing.
Inputs RunsOfDigest(const std::string& path, std::string text) {
  const Source source(path, std::move(text));
  Result<Digest> parsed = ParseDigest(source);
  if (!parsed) return Failure(FirstErrorOf(parsed.diagnostics(), source));
  const auto digest = std::make_shared<const Digest>(std::move(*parsed));
  const Study& study = digest->study;
  ReportInputs inputs;
  inputs.title =
      study.name.empty() ? fs::path(path).filename().string() : study.name;
  inputs.claims.push_back(
      ClaimsOf(inputs.title, ParseClaimsRecord(digest->claims, path)));
  auto next = digest->runs.begin();
  for (const StudyRun& run : RunsOf(study)) {
    ReportInput& input = inputs.runs.emplace_back(
        ReportInput{path + "#" + RunName(study, run), RunName(study, run),
                    study.experiments[run.experiment].name,
                    ExperimentOf(study, run), digest});
    input.study = 0;
    if (next != digest->runs.end() && next->run == run) input.kept = &*next++;
  }
  return inputs;
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
    if (std::optional<std::string> text = DigestText(path))
      return RunsOfDigest(path, std::move(*text));
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

/// The same run by a digest and by a store, or by two digests.
bool IsSameRun(const ReportInput& one, const ReportInput& other) {
  return (one.digest || other.digest) && one.label == other.label &&
         one.expected && other.expected && *one.expected == *other.expected;
}

/// Whether the one record goes on where the other ends, or is the same.
bool GoesOnFrom(const ClaimsRecord& record, const ClaimsRecord& before) {
  return !before.empty() && before.size() <= record.size() &&
         std::equal(before.begin(), before.end(), record.begin(),
                    [](const ClaimsVersion& a, const ClaimsVersion& b) {
                      return a.hash == b.hash && a.stated == b.stated;
                    });
}

/// A study that a folder and a digest both have, or two digests, claims once.
/// Its index.
std::size_t AddClaims(StudyClaims claims, ReportInputs& all) {
  for (std::size_t i = 0; i < all.claims.size(); ++i) {
    StudyClaims& there = all.claims[i];
    if (there.study != claims.study) continue;
    if (GoesOnFrom(there.record, claims.record)) return i;
    if (GoesOnFrom(claims.record, there.record)) {
      there = std::move(claims);
      return i;
    }
  }
  all.claims.push_back(std::move(claims));
  return all.claims.size() - 1;
}

bool HasResults(const ReportInput& run) {
  std::error_code error;
  return run.digest ? run.kept != nullptr : fs::exists(run.path, error);
}

}  // namespace

bool HasDigests(const ReportInputs& inputs) {
  return std::any_of(
      inputs.runs.begin(), inputs.runs.end(),
      [](const ReportInput& run) { return run.digest != nullptr; });
}

Inputs FindRuns(const std::vector<std::string>& paths) {
  ReportInputs all;
  std::map<std::string, std::size_t> seen;  // index of the run
  for (const std::string& path : paths) {
    // Beside runs as a shell names them: *.sqlite.
    if (IsRelivedFile(path) && paths.size() > 1) continue;
    Inputs found = RunsAt(path);
    if (!found) return found;
    const bool has_digests = HasDigests(all) || HasDigests(*found);
    all.title += (all.title.empty() ? "" : ", ") + found->title;
    std::vector<std::size_t> studies;
    for (StudyClaims& claims : found->claims)
      studies.push_back(AddClaims(std::move(claims), all));
    for (ReportInput& run : found->runs) {
      if (run.study) run.study = studies[*run.study];
      const auto [place, is_new] =
          seen.emplace(Canonical(run.path), all.runs.size());
      if (!is_new) {
        // Named alone before its study was named whole.
        ReportInput& there = all.runs[place->second];
        if (!there.study) there.study = run.study;
        continue;
      }
      const auto same = has_digests
                            ? std::find_if(all.runs.begin(), all.runs.end(),
                                           [&](const ReportInput& one) {
                                             return IsSameRun(one, run);
                                           })
                            : all.runs.end();
      place->second = static_cast<std::size_t>(same - all.runs.begin());
      if (same == all.runs.end())
        all.runs.push_back(std::move(run));
      else if (!HasResults(*same))
        *same = std::move(run);
    }
  }
  if (all.runs.empty())
    return Failure("all of these are of relived lives; name their runs");
  return all;
}

}  // namespace plsc
