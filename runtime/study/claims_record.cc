// A version a file, each made whole and under a name that nothing has
// (NewFile::Publish): so no lock is needed, a kill leaves none or all of it,
// and who comes second reads what the first one wrote. A file's last line is a
// hash of all before it, the seal, and a later version names the seal of the
// one before: a file that was changed, cut or taken away from between is
// noticed.

#include "runtime/study/claims_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "grammar/diagnostic.h"
#include "runtime/store/new_file.h"
#include "runtime/study/claim_yaml.h"
#include "runtime/study/run_report.h"
#include "runtime/study/study_folder.h"
#include "runtime/text/key.h"
#include "runtime/text/yaml_reader.h"

namespace plsc {

namespace {

namespace fs = std::filesystem;

constexpr int kClaimsFormat = 1;  // of these files, value of plsc_claims
constexpr int kIndent = 2;        // of the claims in them
constexpr int kMany = 2'000'000;  // runs: more than any study has
constexpr const char* kSeal = "seal: ";
constexpr const char* kFirst = "none";  // that is before the first version
constexpr const char* kHead =
    "# What the study of this folder expects, and since when. Written by plsc "
    "and never\n# rewritten; to change a claim, change the study's file "
    "(docs/studies.md).\n";

struct SealedVersion {
  ClaimsVersion version;
  std::string previous;
  std::string seal;
};

std::string FileOf(const std::string& folder, std::size_t number) {
  return (fs::path(folder) /
          (number == 1 ? "claims.yaml" : fmt::format("claims.{}.yaml", number)))
      .string();
}

bool IsThere(const std::string& path) {
  std::error_code error;
  return fs::exists(path, error);
}

std::string Indented(const std::string& text) {
  std::string indented;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    indented += fmt::format("{:{}}{}\n", "", kIndent, line);
  return indented;
}

std::string Print(const ClaimsVersion& version, const std::string& previous) {
  const std::string claims = PrintClaims(version.claims, 0);
  std::string text = fmt::format(
      "{}plsc_claims: {}\nstated: \"{}\"\nruns: {}\nruns_begun: {}\n"
      "runs_done: {}\nprevious: \"{}\"\nhash: \"{}\"\nclaims: {}\n{}",
      kHead, kClaimsFormat, version.stated, version.runs, version.runs_begun,
      version.runs_done, previous, version.hash, claims.empty() ? "\"\"" : "|",
      Indented(claims));
  return text + fmt::format("{}\"{}\"\n", kSeal, Hex(KeyOf(text)));
}

Failure Changed(const std::string& path, const std::string& why) {
  return fmt::format(
      "'{}' is damaged or was changed by hand: {}; put it back as it was", path,
      why);
}

/// What stands in the text, nothing of it if anything is wrong.
std::vector<Claim> ReadClaimsText(const Source& source,
                                  std::vector<Diagnostic>& problems) {
  if (source.text().empty()) return {};
  const YamlFile file(source);
  std::vector<Claim> claims;
  if (const std::optional<YamlMap> root = file.Root("claims"))
    claims = ReadClaims(root->place(), {}, ClaimCheck::kWords);
  problems = file.diagnostics();
  return claims;
}

Expected<SealedVersion, Failure> ParseVersion(const std::string& path,
                                              const std::string& text) {
  const std::size_t end = text.rfind(kSeal);
  const std::string body = text.substr(0, end);
  SealedVersion sealed;
  sealed.seal = Hex(KeyOf(body));
  if (end == std::string::npos ||
      text.substr(end) != fmt::format("{}\"{}\"\n", kSeal, sealed.seal))
    return Changed(path, "its seal is not that of its text");
  const Source source(path, text);
  const YamlFile file(source);
  std::optional<YamlMap> root = file.Root("claims of a study");
  if (!root) return Changed(path, file.diagnostics().front().message);
  ClaimsVersion& version = sealed.version;
  root->Int("plsc_claims", kClaimsFormat, kClaimsFormat, kClaimsFormat);
  version.stated = root->Text("stated", "");
  version.runs = root->Int("runs", 0, 0, kMany);
  version.runs_begun = root->Int("runs_begun", 0, 0, kMany);
  version.runs_done = root->Int("runs_done", 0, 0, kMany);
  sealed.previous = root->Text("previous", "");
  version.hash = root->Text("hash", "");
  const auto claims = root->Need("claims", "");
  root->Text("seal", "");
  root->Close();
  const Source claims_source(path, claims ? claims->text() : "");
  std::vector<Diagnostic> problems;
  if (file.diagnostics().empty())
    version.claims = ReadClaimsText(claims_source, problems);
  for (const auto& found : {file.diagnostics(), problems})
    if (!found.empty())
      return Failure(fmt::format("'{}' is of another version of plsc: {}", path,
                                 found.front().message));
  if (Hex(KeyOf(claims_source.text())) != version.hash)
    return Changed(path, "its hash is not that of its claims");
  return sealed;
}

Expected<std::vector<std::string>, Failure> ReadTexts(
    const std::string& folder) {
  std::vector<std::string> texts;
  for (;;) {
    const std::string path = FileOf(folder, texts.size() + 1);
    if (!IsThere(path)) {
      if (IsThere(FileOf(folder, texts.size() + 2)))
        return Failure(
            fmt::format("'{}' is missing, and later claims of the "
                        "study are there",
                        path));
      return texts;
    }
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) return Failure(fmt::format("cannot read '{}'", path));
    texts.push_back(text.str());
  }
}

Expected<std::vector<SealedVersion>, Failure> ParseAll(
    const std::vector<std::string>& texts, const std::string& where) {
  std::vector<SealedVersion> all;
  for (const std::string& text : texts) {
    const std::string path = FileOf(where, all.size() + 1);
    Expected<SealedVersion, Failure> one = ParseVersion(path, text);
    if (!one) return one.error();
    if (one->previous != (all.empty() ? kFirst : all.back().seal))
      return Changed(path, "it does not follow from the file before it");
    all.push_back(std::move(*one));
  }
  return all;
}

Expected<std::vector<SealedVersion>, Failure> Read(const std::string& folder) {
  const auto texts = ReadTexts(folder);
  if (!texts) return texts.error();
  return ParseAll(*texts, folder);
}

void CountRuns(const std::string& folder, const Study& study,
               ClaimsVersion& version) {
  for (const StudyRun& run : RunsOf(study)) {
    ++version.runs;
    const RunState state = ReportOn(folder, study, run).state;
    if (state != RunState::kMissing) ++version.runs_begun;
    if (state == RunState::kDone) ++version.runs_done;
  }
}

}  // namespace

MaybeFailure StateClaims(const std::string& folder, const Study& study,
                         const std::string& now) {
  for (;;) {
    const auto there = Read(folder);
    if (!there) return there.error();
    const std::vector<Claim> last =
        there->empty() ? std::vector<Claim>() : there->back().version.claims;
    if (last == study.claims) return std::nullopt;
    ClaimsVersion version;
    version.stated = now;
    CountRuns(folder, study, version);
    version.claims = study.claims;
    version.hash = Hex(KeyOf(PrintClaims(study.claims, 0)));
    const std::string path = FileOf(folder, there->size() + 1);
    NewFile file(path);
    MaybeFailure failure = file.Write(
        Print(version, there->empty() ? kFirst : there->back().seal));
    if (!failure) failure = file.Publish();
    if (!failure) return std::nullopt;
    // Another process was first: what it says is read.
    if (!IsThere(path)) return failure;
  }
}

Expected<std::vector<std::string>, Failure> ClaimsTextsIn(
    const std::string& folder) {
  auto texts = ReadTexts(folder);
  if (texts)
    if (const auto wrong = ParseAll(*texts, folder); !wrong)
      return wrong.error();
  return texts;
}

Expected<ClaimsRecord, Failure> ParseClaimsRecord(
    const std::vector<std::string>& texts, const std::string& where) {
  auto all = ParseAll(texts, where);
  if (!all) return all.error();
  ClaimsRecord record;
  for (SealedVersion& one : *all) record.push_back(std::move(one.version));
  return record;
}

Expected<ClaimsRecord, Failure> ClaimsIn(const std::string& folder) {
  const auto texts = ReadTexts(folder);
  if (!texts) return texts.error();
  return ParseClaimsRecord(*texts, folder);
}

void AddClaimedMeasures(const ClaimsRecord& record,
                        std::vector<ReportMeasure>& measures) {
  for (const ClaimsVersion& version : record)
    for (const Claim& claim : version.claims) {
      const std::optional<ReportMeasure> measure = FindMeasure(claim.measure);
      const auto is_it = [&](const ReportMeasure& one) {
        return one.id == measure->id;
      };
      if (measure && std::none_of(measures.begin(), measures.end(), is_it))
        measures.push_back(*measure);
    }
}

std::vector<StatedClaim> StatedClaims(const ClaimsRecord& record) {
  std::vector<StatedClaim> stands;
  std::vector<StatedClaim> withdrawn;
  for (std::size_t i = 0; i < record.size(); ++i) {
    std::vector<StatedClaim> next;
    for (const Claim& claim : record[i].claims) {
      const auto before = std::find_if(
          stands.begin(), stands.end(),
          [&](const StatedClaim& one) { return one.claim == claim; });
      next.push_back(before == stands.end() ? StatedClaim{claim, i, {}}
                                            : *before);
    }
    for (StatedClaim& one : stands)
      if (std::find(record[i].claims.begin(), record[i].claims.end(),
                    one.claim) == record[i].claims.end()) {
        one.withdrawn = i;
        withdrawn.push_back(std::move(one));
      }
    stands = std::move(next);
  }
  stands.insert(stands.end(), withdrawn.begin(), withdrawn.end());
  return stands;
}

std::string WhenStated(const ClaimsVersion& version) {
  if (version.runs_begun == 0) return "before the first run";
  return fmt::format("after {} of {} runs had begun ({} {} done)",
                     version.runs_begun, version.runs, version.runs_done,
                     version.runs_done == 1 ? "was" : "were");
}

}  // namespace plsc
