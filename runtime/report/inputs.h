#pragma once

// Which runs a report is of: the folders and files that a user names, each
// with the experiment that it repeats.

#include <optional>
#include <string>
#include <vector>

#include "grammar/expected.h"
#include "grammar/failure.h"
#include "runtime/evolve/experiment.h"

namespace plsc {

struct ReportInput {
  std::string path;   ///< of the store, which may be missing in a study
  std::string label;  ///< "plastic/3", or the file's name
  /// The study's; empty for files, which belong together if their experiments
  /// differ in names and seeds only.
  std::string experiment;
  std::optional<Experiment> expected;  ///< the study's
};

struct ReportInputs {
  std::string title;  ///< the study's name, or that of the only path
  std::vector<ReportInput> runs;
};

/// Paths are folders of studies, folders of one of their experiments, folders
/// of runs (*.sqlite), and runs. A run that several of them name is there once,
/// and files of relived lives are left out.
Expected<ReportInputs, Failure> FindRuns(const std::vector<std::string>& paths);

}  // namespace plsc
