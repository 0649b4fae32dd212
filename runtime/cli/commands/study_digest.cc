#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "grammar/shown_line.h"
#include "runtime/cli/arguments/study.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/cli/files/output_path.h"
#include "runtime/report/digest.h"
#include "runtime/study/claims_record.h"
#include "runtime/study/study_folder.h"

namespace plsc::cli {

namespace {

// Every tenth generation: of the paper's 200, 21, as many as a figure's width
// has use for.
constexpr int kEvery = 10;

/// The one that is there, or an empty one; nothing if it is none, which is
/// printed.
std::optional<Digest> Begun(const StudyDigestCommand& command,
                            const Study& study, Io& io) {
  std::error_code error;
  // A pipe or a device has nothing to add to, and to read it may never end.
  if (command.force || !std::filesystem::is_regular_file(command.output, error))
    return Digest{study, {}, kEvery, {}};
  const std::optional<Source> source = ReadOrReport(command.output, io);
  if (!source) return std::nullopt;
  if (source->text().empty()) return Digest{study, {}, kEvery, {}};
  Result<Digest> digest = ParseDigest(*source);
  if (!digest) {
    Report(digest.diagnostics(), *source, io);
    return std::nullopt;
  }
  return std::move(*digest);
}

/// More repetitions are the same study.
bool AreOfOneStudy(Study one, const Study& other) {
  one.repetitions = other.repetitions;
  return one == other;
}

/// The same runs with other measures.
void Measure(const std::vector<ReportMeasure>& measures, Digest& digest) {
  if (digest.measures == measures) return;
  for (DigestRun& run : digest.runs)
    run.reading = ReadingOf(digest, run, measures);
  digest.measures = measures;
}

/// What the user asks for is added to what is there.
std::optional<Failure> ChooseKept(const StudyDigestCommand& command,
                                  Digest& digest) {
  std::vector<ReportMeasure> measures = digest.measures;
  if (!command.measures.empty() || measures.empty()) {
    auto chosen =
        ChooseMeasures(command.measures.empty() ? "paper" : command.measures);
    if (!chosen) return chosen.error();
    if (HasOwnFitness(digest.study)) UseOwnFitness(*chosen);
    for (const ReportMeasure& one : *chosen)
      if (std::find(measures.begin(), measures.end(), one) == measures.end())
        measures.push_back(one);
  }
  const auto record = ParseClaimsRecord(digest.claims, command.folder);
  if (!record) return record.error();
  AddClaimedMeasures(*record, measures);
  if (HasOwnFitness(digest.study)) UseOwnFitness(measures);
  Measure(measures, digest);
  if (command.every) digest.every = *command.every;
  return std::nullopt;
}

/// What is claimed, as the folder has it, later changes included. A digest of
/// runs from several folders keeps the record that it has.
std::optional<Failure> TakeClaims(const StudyDigestCommand& command,
                                  Digest& digest, Io& io) {
  auto texts = ClaimsTextsIn(command.folder);
  if (!texts) return texts.error();
  const std::vector<std::string>& kept = digest.claims;
  if (kept.size() <= texts->size() &&
      std::equal(kept.begin(), kept.end(), texts->begin()))
    digest.claims = std::move(*texts);
  else if (!texts->empty())
    io.err << fmt::format(
        "warning: '{}' keeps the claims that it has; '{}' stated its own\n",
        Escaped(command.output), Escaped(command.folder));
  return std::nullopt;
}

struct Added {
  int runs = 0;
  int damaged = 0;
};

Added AddRuns(const StudyDigestCommand& command, Digest& digest, Io& io) {
  Added added;
  for (const StudyRun& run : RunsOf(digest.study)) {
    auto one = DigestOf(command.folder, digest, run);
    if (!one) {
      ++added.damaged;
      io.err << fmt::format("error: {}\n", Escaped(one.error().text));
    } else if (*one) {
      ++added.runs;
      AddRun(std::move(**one), digest);
    }
  }
  return added;
}

}  // namespace

Exit Run(const StudyDigestCommand& command, Io& io) {
  const Expected<Study, Failure> study = StudyIn(command.folder);
  if (!study) return Complain(study.error(), io);
  const Output output{command.output, OutputKind::kDigest, command.force};
  if (!CanWrite(output, io)) return Exit::kBadInput;
  std::optional<Digest> digest = Begun(command, *study, io);
  if (!digest) return Exit::kBadInput;
  if (!AreOfOneStudy(digest->study, *study))
    return Complain(
        fmt::format("'{}' is a digest of another study than '{}'; give this "
                    "one a file of its own",
                    command.output, command.folder),
        io);
  digest->study.repetitions =
      std::max(digest->study.repetitions, study->repetitions);
  if (const auto failure = TakeClaims(command, *digest, io))
    return Complain(*failure, io);
  if (const auto failure = ChooseKept(command, *digest))
    return Complain(*failure, io);
  const Added added = AddRuns(command, *digest, io);
  if (!WriteOutput(output, PrintDigest(*digest), io)) return Exit::kBadInput;
  if (!command.quiet)
    io.out << fmt::format("{}: {} of {} runs, {} of them from '{}'\n",
                          Escaped(command.output), digest->runs.size(),
                          RunsOf(digest->study).size(), added.runs,
                          Escaped(command.folder));
  return added.damaged > 0 ? Exit::kBadInput : Exit::kFine;
}

}  // namespace plsc::cli
