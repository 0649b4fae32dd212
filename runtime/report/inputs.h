#pragma once

// Which runs a report is of: the folders and files that a user names, each
// with the experiment that it repeats. Stores are read later; the runs of a
// digest, which is one file, are read here.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grammar/expected.h"
#include "grammar/failure.h"
#include "runtime/evolve/experiment.h"
#include "runtime/report/digest.h"
#include "runtime/study/claims_record.h"

namespace plsc {

struct ReportInput {
  std::string path;   ///< of the store, which may be missing in a study
  std::string label;  ///< "plastic/3", or the file's name
  /// The study's; empty for files, which belong together if their experiments
  /// differ in names and seeds only.
  std::string experiment;
  std::optional<Experiment> expected;  ///< the study's
  /// Of a digest, whose runs have no store; nothing if it lacks the run.
  std::shared_ptr<const Digest> digest = nullptr;
  const DigestRun* kept = nullptr;  ///< in the digest
  /// Index into ReportInputs::claims, if the whole study was named.
  std::optional<std::size_t> study{};
};

/// What a study that was named claims.
struct StudyClaims {
  std::string study;  ///< its title
  ClaimsRecord record;
  std::string problem;  ///< why the record cannot be read
};

struct ReportInputs {
  std::string title;  ///< the study's name, or that of the only path
  std::vector<ReportInput> runs;
  std::vector<StudyClaims> claims{};
};

/// Whether a run is of a digest, which has no stores to look into.
bool HasDigests(const ReportInputs& inputs);

/// Paths are folders of studies, folders of one of their experiments, folders
/// of runs (*.sqlite), runs, and digests of studies. A run that several of them
/// name is there once, and files of relived lives are left out.
Expected<ReportInputs, Failure> FindRuns(const std::vector<std::string>& paths);

}  // namespace plsc
