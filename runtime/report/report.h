#pragma once

// A report before it is written: every run that was read, which experiments
// they repeat, and which of these are compared in which seasons. All numbers
// follow from it (comparison.h).

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "runtime/report/engine_check.h"
#include "runtime/report/inputs.h"
#include "runtime/report/read_relived.h"
#include "runtime/report/read_run.h"

namespace plsc {

struct ReportRun {
  ReportInput input;
  RunReading reading;
  /// Of its best robots, where it was asked for.
  std::optional<EngineCheck> check;
  /// Of the generation that is compared (AddRelived).
  RelivedReading relived;
};

struct ReportExperiment {
  std::string name;               ///< of no other one in the report
  Experiment experiment;          ///< of its first run
  std::vector<std::size_t> runs;  ///< indices into StudyReport::runs
  /// One season only, while others have more: the paper's red lines, what is
  /// reached where the environment never changes.
  bool is_static = false;
  /// By season of its own: the index into StudyReport::seasons that it is shown
  /// in. That of a static experiment is the one of the same terrain.
  std::vector<std::size_t> seasons;
};

struct StudyReport {
  std::string title;
  std::vector<StudyClaims> claims;  ///< of the studies that were named whole
  std::vector<ReportMeasure> measures;  ///< those of claims included
  std::vector<ReportRun> runs;  ///< in the order in which they were named
  std::vector<ReportExperiment> experiments;
  std::vector<std::string> seasons;  ///< that charts are made for
  /// That experiments are compared at: the last one that a run of every
  /// experiment which has begun has completed; -1 if there is none.
  int generation = -1;
  bool is_single = false;  ///< one run: curves are of its population
  /// Some runs are of a digest: there are numbers of some generations only.
  bool is_thinned = false;
  bool is_verified = false;  ///< every row was compared with its checksum
  /// That makes relived lives of all runs; empty: not known.
  std::string relive_command;
};

/// Told after each run, with how many of how many are read.
using ReportProgress = std::function<void(std::size_t done, std::size_t total)>;

/// `verify`: compare all results with their checksums, which takes many times
/// as long as to read them.
StudyReport BuildReport(const ReportInputs& inputs,
                        const std::vector<ReportMeasure>& measures,
                        const ReportProgress& on_run, bool verify = false);

/// Reads what was lived again of the generation that is compared, of each run
/// that has completed it.
void AddRelived(StudyReport& report);

}  // namespace plsc
