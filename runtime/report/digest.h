#pragma once

// A study without its stores: of every run that is done what a report's figures
// and tests need, a line each, in a text that is small enough to be committed
// beside a paper. Stores of a study of the paper's size are gigabytes, and get
// lost; from a digest the report is made again, and from its rows (the study,
// a seed, a version, a command) any of its stores, bit for bit. Runs that are
// done later, or elsewhere, join the others.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/expected.h"
#include "grammar/failure.h"
#include "grammar/result.h"
#include "runtime/report/read_relived.h"
#include "runtime/report/read_run.h"
#include "runtime/study/report_measures.h"
#include "runtime/study/study.h"

namespace plsc {

/// How every digest begins.
inline constexpr std::string_view kDigestMark = R"({"plsc_digest":)";

struct DigestRun {
  StudyRun run;
  std::string genotype;  ///< of the best robot of the last generation, as text
  /// kDone. Without portrait, rules and constants; numbers with six digits, of
  /// every Digest::every-th generation and the last.
  RunReading reading;
  /// kHere or kMissing. Of the last generation; without its robots, and without
  /// quartiles over them.
  RelivedReading relived{};
};

struct Digest {
  Study study;
  std::vector<ReportMeasure> measures;  ///< that readings have
  int every = 10;                       ///< generations, at least 1
  std::vector<DigestRun> runs;          ///< in the order of RunsOf
  std::vector<std::string> claims{};    ///< as ClaimsTextsIn the folder
};

/// Whether a generation's numbers are kept.
bool IsKept(int generation, int generations, int every);

/// One JSON object, a run a line (docs/formats.md).
std::string PrintDigest(const Digest& digest);
Result<Digest> ParseDigest(const Source& json);

/// The run of the study in its folder; nothing if it is not done. Fails where
/// it cannot be read.
Expected<std::optional<DigestRun>, Failure> DigestOf(const std::string& folder,
                                                     const Digest& digest,
                                                     const StudyRun& run);

/// The run's reading with these measures; those that the digest lacks have no
/// numbers.
RunReading ReadingOf(const Digest& digest, const DigestRun& run,
                     const std::vector<ReportMeasure>& measures);

/// Adds a run, in its place, or puts it where it was. What was lived again
/// stays, if the same run comes without it.
void AddRun(DigestRun run, Digest& digest);

/// The command that makes the run's store again.
std::string CommandFor(const Study& study, const StudyRun& run);

}  // namespace plsc
